#include "app/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/command_line/common_options.hpp"
#include "app/command_line/sumo_words.hpp"
#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/interrupts.hpp"
#include "app/output_files.hpp"
#include "app/progress.hpp"
#include "app/step_watch.hpp"
#include "app/summary.hpp"
#include "app/supervise.hpp"
#include "app/temporary_folder.hpp"
#include "app/thread_limit.hpp"
#include "app/warnings.hpp"
#include "core/error.hpp"
#include "results/trajectories.hpp"
#include "sumo/files/person_detectors.hpp"
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

/// SUMO has read its people when pedzone joins.
void require_no_panel(const RunOptions& options, const ZoneFile& file) {
  if (file.panels.empty()) return;
  throw InputError("asks for people, and SUMO runs already",
                   {options.zone_file, 0, "<pedestrians>", "",
                    "`pedzone demand` to write them as a route file, for SUMO to start with"});
}

/// Made where it is not there, with its whole path: SUMO writes the pictures. Empty: none.
std::string picture_folder(const std::string& folder) {
  if (folder.empty()) return folder;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError("cannot be made: " + error.message(),
                     {"", 0, "--screenshots", folder, "a folder that can be written"});
  }
  return std::filesystem::absolute(folder).string();
}

SimulationOptions prepare(const RunOptions& options) {
  SimulationOptions prepared;
  prepared.scenario = read_scenario(options.config, options.sumo_options);
  if (options.end) {
    require_later_end(prepared.scenario, *options.end,
                      {.element = "option --end", .value = fmt::format("{:g}", *options.end)});
  }
  ZoneFile file = read_zone_file(options.zone_file, options.panel);
  if (options.attach) {
    require_no_panel(options, file);
  } else if (file.panels.empty()) {
    tell_of_nobody(options, prepared.scenario);
  }
  prepared.needs_zone = options.strict || options.attach || !file.panels.empty();
  prepared.attach = options.attach;
  prepared.screenshots = picture_folder(options.screenshots);
  if (options.own_process()) prepared.own = options.own;
  if (options.own.clients > 0 && options.own.port == 0) prepared.own->port = TraciAddress{}.port;
  prepared.alone = !options.attach && options.own.all_clients() == 0;
  if (options.model) set_model(*options.model, file.zones);
  prepared.zones = std::move(file.zones);
  prepared.profiles = std::move(file.profiles);
  prepared.paths = std::move(file.paths);
  prepared.panels = std::move(file.panels);
  prepared.vehicle_paths = read_vehicle_paths(file.vehicle_paths);
  prepared.seed = options.seed;
  prepared.end = options.end;
  return prepared;
}

/// Tells of a run that was ended early, at `time` [s].
void warn_of_interrupt(const RunSummary& totals, double time) {
  fmt::print(
      stderr,
      "Interrupted at {:.1f} s (signal {}): the outputs hold what was simulated until then.\n",
      time, totals.interrupted_by);
}

void warn_of_stranded(const std::vector<std::string>& ids) {
  if (ids.empty()) return;
  print_warning(
      fmt::format("{} persons stand where pedzone left them, e.g. '{}': their routes have no lane "
                  "for persons, of 0.5 m or more, on which SUMO could walk them on.",
                  ids.size(), ids.front()));
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
  constexpr std::size_t kTold = 3;  // of each zone
  for (const Zone& zone : simulation.zones()) {
    const std::size_t all = zone.warnings.size(), told = std::min(all, kTold);
    for (std::size_t i = 0; i < told; ++i) {
      print_warning(fmt::format("zone '{}': {}.", zone.id, zone.warnings[i]));
    }
    if (all > told) {
      print_warning(fmt::format("zone '{}': {} more of its shape; `pedzone inspect` lists them.",
                                zone.id, all - told));
    }
  }
}

void warn_of_counts(const Simulation& simulation, const Scenario& scenario) {
  if (simulation.miscounts_walking()) {
    print_warning(
        "in person-summary-output 'walking' and 'riding' are wrong, but their sum is right: SUMO "
        "counts each place of somebody whom pedzone walks as one more who walks.");
  }
  if (simulation.zones().empty()) return;
  const std::vector<std::string> detectors = person_detectors(scenario);
  if (detectors.empty()) return;
  print_warning(fmt::format(
      "{} {} to count people (detectPersons), such as '{}': SUMO does not count there whom pedzone "
      "walks. --trajectories has everybody.",
      detectors.size(), detectors.size() == 1 ? "detector is" : "detectors are",
      detectors.front()));
}

/// SUMO does not tell what other clients have told a vehicle.
void warn_of_drivers(const Simulation& simulation) {
  if (!simulation.misses_drivers()) return;
  print_warning(
      "no vehicle near a zone was declared to be driven by another program. What a client that "
      "comes before pedzone tells a vehicle (setSpeed, slowDown) pedzone overwrites near people. "
      "If a client drives one, set pedzone.external=\"true\" on it or its vType.");
}

/// To its end, or until it is interrupted. What ended it early, if SUMO did.
std::string walk(Simulation& simulation, OutputFiles& outputs, Progress& progress,
                 StepWatch& watch) {
  std::string lost;
  JamWarnings jams;
  StuckWarning stuck;
  OutsideNotes outside;
  progress.start(simulation.time(), simulation.end_time());
  note_interrupts();
  while (!simulation.finished() && noted_interrupt() == 0) {
    const double time = simulation.time();
    watch.begin("for SUMO, which waits for another of its clients to do its step");
    try {
      simulation.step();
    } catch (const ConnectionLost& error) {
      lost = error.what();
    }
    watch.end();
    if (!lost.empty()) break;
    outputs.step(time, simulation);
    jams.step(simulation, progress);
    stuck.step(simulation, progress);
    outside.step(simulation, progress);
    progress.update(simulation.time(), simulation.guests().size());
  }
  progress.finish();
  jams.finish(simulation, progress);
  return noted_interrupt() == 0 ? lost : "";
}

/// What SUMO tells of the whole run. `lost`: if it goes only now, that it did.
RunSummary sum_up(Simulation& simulation, std::string& lost) {
  try {
    return simulation.summary();
  } catch (const ConnectionLost& error) {
    lost = error.what();
  }
  return simulation.summary();
}

/// Ends SUMO. What went wrong with that: what was simulated is complete all the same.
std::string close(Simulation& simulation) {
  try {
    simulation.close();
  } catch (const SumoError& error) {
    return error.what();
  }
  return "";
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
  StepWatch watch(options.attach || options.own.all_clients() > 0);
  watch.begin("for SUMO to be there with all its clients (--remote-port, --num-clients)");
  Simulation simulation(prepared);
  watch.end();
  outputs.begin(simulation);
  tell_of_no_zone(options, simulation);
  warn_of_far_places(simulation.network());
  warn_of_shapes(simulation);
  warn_of_counts(simulation, prepared.scenario);
  std::string lost = walk(simulation, outputs, progress, watch);
  RunSummary totals = sum_up(simulation, lost);
  const double ended_at = simulation.time();
  warn_of_drivers(simulation);
  totals.interrupted_by = noted_interrupt();
  totals.sumo_gone = !lost.empty();
  const bool warns = !options.attach && !options.own_process() && simulation.warns();
  const std::string unclosed = close(simulation);
  if (warns) totals.sumo.warnings = progress.warnings();
  outputs.finish(simulation, totals);
  print_result(summary_table(totals));
  warn_of_stranded(simulation.stranded());
  if (totals.sumo_gone) throw SumoError(lost + " The outputs hold what was simulated until then.");
  if (!unclosed.empty()) throw SumoError(unclosed + " pedzone's own outputs are complete.");
  if (totals.interrupted_by == 0) return 0;
  warn_of_interrupt(totals, ended_at);
  return 128 + totals.interrupted_by;
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
    "Waypoints: a zone file can have <path id=\"ID\" waypoints=\"poi1 poi2\"/>. Persons with the\n"
    "parameter pedzone.path=ID (their own or their vType's) pass these POIs in this order.\n"
    "The POIs have the type pedzone.waypoint.\n\n"
    "sumo-gui shows what --debug-shapes writes: sumo-gui -c FILE -a POLYGONS,SHAPES.\n\n"
    "Outputs: - is standard output, NAME.gz is compressed.\n"
    "Exit codes: 0 done, 2 input at fault, 3 SUMO failed, 128 + signal: interrupted.";

/// The parent makes the folder and removes it, however the child ends.
int run_in_child(const RunOptions& options) {
  const auto work = [options = options]() mutable {
    return guarded_code([&] {
      require_different_outputs(options);
      keep_standard_output_clean(options);
      return simulate(options);
    });
  };
  return supervise(work, outputs_of(options));
}

}  // namespace

int run(const RunOptions& options) {
  if (options.animation.empty()) return run_in_child(options);
  return guarded_code([&] {
    const TemporaryFolder scratch;
    RunOptions with_scratch = options;
    with_scratch.scratch = scratch.path();
    return run_in_child(with_scratch);
  });
}

void add_run(CLI::App& app, int& code) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand(
      "run", "Run a SUMO scenario; pedzone walks its persons through shared space");
  command->footer(kFooter);
  add_walking_options(*command, *options);
  add_strict_flag(*command, *options);
  add_process_options(*command, *options);
  add_output_options(*command, *options);
  command
      ->add_option("--animate", options->animation,
                   "Make an animation: one HTML file that plays offline, as `pedzone animate` does")
      ->type_name(kFile)
      ->group("Outputs");
  add_conflict_options(*command, options->conflicts);
  add_panel_options(*command, options->panel);
  add_sumo_words(*command, options->sumo_options);
  set_callback(*command, options, run, code);
}

}  // namespace pedzone
