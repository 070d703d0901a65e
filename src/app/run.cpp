#include "app/run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/command_line/common_options.hpp"
#include "app/command_line/sumo_words.hpp"
#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/interrupts.hpp"
#include "app/output_files.hpp"
#include "app/progress.hpp"
#include "app/summary.hpp"
#include "app/supervise.hpp"
#include "app/temporary_folder.hpp"
#include "app/thread_limit.hpp"
#include "app/warnings.hpp"
#include "core/error.hpp"
#include "results/trajectories.hpp"
#include "sumo/simulation.hpp"

namespace pedzone {
namespace {

/// Has every zone walked by the model; the zone that is found by itself, too.
void set_model(const std::string& model, std::vector<ZoneSpec>& zones) {
  require_models({model});
  if (zones.empty()) zones.emplace_back();
  for (ZoneSpec& zone : zones) zone.model = model;
}

/// A study of many towns goes on.
void tell_of_nobody(const RunOptions& options, const Scenario& scenario) {
  if (names_person(scenario)) return;
  const InputError error = no_person(scenario);
  if (options.strict) throw error;
  print_warning(fmt::format("{}. Nobody is walked.", error.what()));
}

void tell_of_no_zone(const RunOptions& options, const Simulation& simulation) {
  if (!simulation.zones().empty()) return;
  print_warning(fmt::format(
      "{} has no shared space: SUMO walks everybody. `pedzone inspect {}` shows "
      "edges that could be a zone, and what a zone file (--zone) has to say of them. With "
      "--strict this is an error.",
      simulation.network().file, options.config));
}

SimulationOptions prepare(const RunOptions& options) {
  SimulationOptions prepared;
  prepared.scenario = read_scenario(options.config, options.sumo_options);
  ZoneFile file = read_zone_file(options.zone_file, options.panel);
  if (file.panels.empty()) tell_of_nobody(options, prepared.scenario);
  prepared.needs_zone = options.strict || !file.panels.empty();
  if (options.model) set_model(*options.model, file.zones);
  prepared.zones = std::move(file.zones);
  prepared.profiles = std::move(file.profiles);
  prepared.paths = std::move(file.paths);
  prepared.panels = std::move(file.panels);
  if (!options.zone_file.empty()) prepared.vehicle_paths = read_vehicle_paths(options.zone_file);
  prepared.seed = options.seed;
  prepared.end = options.end;
  return prepared;
}

/// Tells of a run that was ended early.
void warn_of_interrupt(const RunSummary& totals) {
  fmt::print(
      stderr,
      "Interrupted at {:.1f} s (signal {}): the outputs hold what was simulated until then.\n",
      totals.time.simulated_s, totals.interrupted_by);
}

/// Farther out people decide otherwise by rounding; measured: nearer they do as at the origin, to
/// 1 nm (cli.any_scenario).
void warn_of_far_places(const Network& network) {
  constexpr double kFar = 8388608.0;  // [m] 2^23
  const bool far = std::ranges::any_of(network.lanes, [](const Lane& lane) {
    return std::ranges::any_of(
        lane.shape, [](const Vec2& point) { return point.cwiseAbs().maxCoeff() > kFar; });
  });
  if (!far) return;
  print_warning(
      fmt::format("{} has coordinates beyond {:.0f} m: people walk a little differently there "
                  "than near the origin. netconvert's --offset.x and --offset.y move a network.",
                  network.file, kFar));
}

void warn_of_shapes(const Simulation& simulation) {
  for (const Zone& zone : simulation.zones()) {
    if (zone.warnings.empty()) continue;
    fmt::print(stderr, "Zone '{}': {} warnings about its shape; `pedzone inspect` lists them.\n",
               zone.id, zone.warnings.size());
  }
}

/// To its end, or until it is interrupted.
void walk(Simulation& simulation, OutputFiles& outputs, Progress& progress) {
  JamWarnings jams;
  StuckWarning stuck;
  progress.start(simulation.time(), simulation.end_time());
  note_interrupts();
  while (!simulation.finished() && noted_interrupt() == 0) {
    const double time = simulation.time();
    simulation.step();
    outputs.step(time, simulation);
    jams.step(simulation, progress);
    stuck.step(simulation, progress);
    progress.update(simulation.time(), simulation.guests().size());
  }
  progress.finish();
  jams.finish(simulation, progress);
}

/// Its exit code: 0, or 128 + the signal that ended it early.
int simulate(RunOptions& options) {
  const ThreadLimit limit(options.threads);
  SimulationOptions prepared = prepare(options);
  if (!options.animation.empty()) {
    options.recorded = record_everybody(prepared.scenario, options.scratch);
  }
  OutputFiles outputs(options);
  Progress progress(!is_quiet() && !has_step_log(prepared.scenario));
  Simulation simulation(prepared);
  outputs.begin(simulation);
  tell_of_no_zone(options, simulation);
  warn_of_far_places(simulation.network());
  warn_of_shapes(simulation);
  walk(simulation, outputs, progress);
  RunSummary totals = simulation.summary();
  totals.interrupted_by = noted_interrupt();
  const bool warns = simulation.warns();
  simulation.close();
  if (warns) totals.sumo.warnings = progress.warnings();
  outputs.finish(simulation, totals);
  print_result(summary_table(totals));
  if (totals.interrupted_by == 0) return 0;
  warn_of_interrupt(totals);
  return 128 + totals.interrupted_by;
}

/// The parent makes the folder and removes it, however the child ends.
int run_with(const RunOptions& options) {
  const auto work = [options = options]() mutable {
    keep_standard_output_clean(options);
    return guarded_code([&] { return simulate(options); });
  };
  return supervise(work, outputs_of(options));
}

int run(const RunOptions& options) {
  if (options.animation.empty()) return run_with(options);
  return guarded_code([&] {
    const TemporaryFolder scratch;
    RunOptions with_scratch = options;
    with_scratch.scratch = scratch.path();
    return run_with(with_scratch);
  });
}

constexpr const char* kFooter =
    "Examples:\n"
    "  pedzone run town.sumocfg\n"
    "  pedzone run town.sumocfg --animate town.html          # to be opened in a browser\n"
    "  pedzone run town.sumocfg --seed 7 --end 900 --summary out/summary.json \\\n"
    "              --trajectories out/trajectories.csv -- --tripinfo-output out/trips.xml\n"
    "  pedzone run town.sumocfg --pedestrians 200            # 200 people more, of all kinds\n"
    "  pedzone run town.sumocfg --pedestrians-per-hour 600 --pedestrians-end 900 \\\n"
    "              --pedestrians-profiles \"senior=0.5 wheelchair=0.1\" --end 1200\n\n"
    "Without --zone, the zone is all shared space of the network: edges of type\n"
    "highway.pedestrian and highway.living_street and lanes that persons and vehicles share at\n"
    "no more than 20 km/h. `pedzone inspect` shows it.\n\n"
    "Persons with the parameter pedzone.path (their own or their vType's) come by the POIs of\n"
    "type pedzone.waypoint that <path id=\"...\" waypoints=\"poi1 poi2\"/> in the zone file "
    "names,\n"
    "in turn. sumo-gui shows what --debug-shapes writes: sumo-gui -c FILE -a POLYGONS,SHAPES.\n\n"
    "Outputs: - is standard output, NAME.gz is compressed.\n"
    "Exit codes: 0 done, 2 input at fault, 3 SUMO failed, 128 + signal: interrupted.";

void add_input_options(CLI::App& command, RunOptions& options) {
  const char* group = "What is run";
  add_scenario(command, options.config, options.zone_file);
  command.get_option("--zone")->group(group);
  command.add_option("--model", options.model, "Walking model of every zone, or a plug-in (*.so)")
      ->check(any_beside(model_names()))
      ->type_name(kModelValue)
      ->default_str("the zone's, else heuristic")
      ->group(group);
  command.add_option("--seed", options.seed, "Seed of SUMO and pedzone")
      ->check(a_seed())
      ->type_name(kNumber)
      ->default_str("SUMO's")
      ->group(group);
  command.add_option("--end", options.end, "End time")
      ->check(number_in(0, kLongestTime))
      ->type_name(kSeconds)
      ->default_str("the scenario's")
      ->group(group);
  add_threads(command, options.threads)->group(group);
  command
      .add_flag("--strict", options.strict,
                "A scenario without persons or without shared space is an error; else it runs as "
                "in SUMO, with a warning")
      ->group(group);
}

void add_output_options(CLI::App& command, RunOptions& options) {
  const auto add = [&](const char* name, std::string& file, const std::string& what) {
    return command.add_option(name, file, what)->type_name(kFile)->group("Outputs");
  };
  add("--summary", options.summary, "Write the summary as JSON");
  auto* trajectories =
      add("--trajectories", options.trajectories,
          fmt::format("Write {} of each person and step; NAME.sqlite: JuPedSim's database; "
                      "NAME.txt: PedPy's text, with NAME.ids.csv",
                      fmt::join(trajectory_table().names(), ", ")));
  command
      .add_option("--trajectories-of", options.trajectories_of,
                  "Whose, in NAME.sqlite and NAME.txt: zones: whom pedzone walks; all: whom SUMO "
                  "walks, too")
      ->check(one_of({"zones", "all"}))
      ->type_name(kNames)
      ->capture_default_str()
      ->group("Outputs")
      ->needs(trajectories);
  auto* edge_data =
      add("--edge-data", options.edge_data,
          "Write density, speed and time loss of people by edges of the zones, as SUMO's edgeData");
  command.add_option("--edge-data-period", options.edge_data_period, "An interval of those")
      ->check(number_in(0.1, kLongestTime))
      ->type_name(kSeconds)
      ->default_str("the whole run")
      ->group("Outputs")
      ->needs(edge_data);
  add("--paths-svg", options.picture, "Draw people's paths over the zone");
  add("--animate", options.animation,
      "Make an animation: one HTML file that plays offline, as `pedzone animate` makes it");
  auto* shapes = add(
      "--debug-shapes", options.debug_shapes,
      "Write paths, waypoints and each person's aim, direction and free distances as SUMO shapes");
  command.add_option("--debug-time", options.debug_time, "Time of those shapes")
      ->check(number_in(0, kLongestTime))
      ->type_name(kSeconds)
      ->default_str("the end of the run")
      ->group("Outputs")
      ->needs(shapes);
}

}  // namespace

void add_run(CLI::App& app, int& code) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand(
      "run", "Run a SUMO scenario; pedzone walks its persons through shared space");
  command->footer(kFooter);
  add_input_options(*command, *options);
  add_output_options(*command, *options);
  add_conflict_options(*command, options->conflicts);
  add_panel_options(*command, options->panel);
  add_sumo_words(*command, options->sumo_options);
  set_callback(*command, options, run, code);
}

}  // namespace pedzone
