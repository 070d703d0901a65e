// The command line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/animate.hpp"
#include "app/conflicts.hpp"
#include "app/demand.hpp"
#include "app/geojson.hpp"
#include "app/guarded.hpp"
#include "app/inspect.hpp"
#include "app/parameter_table.hpp"
#include "app/plot.hpp"
#include "app/profile_tables.hpp"
#include "app/run.hpp"
#include "app/study.hpp"
#include "app/validate.hpp"
#include "app/verify.hpp"
#include "core/error.hpp"
#include "results/trajectories.hpp"
#include "study/plan/sumo_options.hpp"
#include "world/model_names.hpp"

namespace pedzone {
namespace {

/// What to do about an option that stands on the wrong side of `--`; empty: nothing is known.
std::string hint_before(const std::vector<std::string>& unknown) {
  for (const std::string& word : unknown) {
    const std::string name = word.substr(word.find_first_not_of('-') == 2 ? 2 : 0);
    if (name == word) continue;
    try {
      if (!study::known_sumo_option(name.substr(0, name.find('=')))) continue;
    } catch (const std::exception&) {  // no `sumo` that could tell: no hint
      return "";
    }
    return "--" + name + " is an option of SUMO: options of SUMO go after --.\n";
  }
  return "";
}

/// Throws InputError for an option of the command's that SUMO does not have.
void require_sumo_options(const CLI::App& command, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || command.get_option_no_throw(name) == nullptr) continue;
    if (study::known_sumo_option(name.substr(2))) continue;
    throw InputError("is an option of pedzone",
                     {"", 0, "after --", name, "options of SUMO; those of pedzone go before --"});
  }
}

/// Makes the command what `call` does, once what goes to SUMO is found to be SUMO's. Both outlive
/// the parsing of the command line.
template <class Options>
void set_callback(CLI::App& command, Options& options, int (*call)(const Options&), int& code) {
  command.callback([&command, &options, call, &code] {
    code = guarded([&] { require_sumo_options(command, options.sumo_options); });
    if (code == 0) code = call(options);
  });
}

void add_run(CLI::App& app, RunOptions& options, int& code) {
  CLI::App* run_command = app.add_subcommand(
      "run", "Run a SUMO scenario; pedzone walks its persons through shared space");
  run_command->footer(
      "Examples:\n"
      "  pedzone run town.sumocfg\n"
      "  pedzone run town.sumocfg --seed 7 --end 900 --summary out/summary.json \\\n"
      "              --trajectories out/trajectories.csv -- --tripinfo-output out/trips.xml\n"
      "  pedzone run town.sumocfg --pedestrians 200            # 200 people more, of all kinds\n"
      "  pedzone run town.sumocfg --pedestrians-per-hour 600 --pedestrians-end 900 \\\n"
      "              --pedestrians-profiles \"senior=0.5 wheelchair=0.1\" --end 1200\n\n"
      "Without --zone, the zone is all shared space of the network: edges of type\n"
      "highway.pedestrian and highway.living_street and lanes that persons and vehicles share at\n"
      "no more than 20 km/h. `pedzone inspect` shows it. Everything after -- goes to SUMO and "
      "wins\n"
      "over what pedzone would tell it.\n\n"
      "Persons with the parameter pedzone.path (their own or their vType's) come by the POIs of\n"
      "type pedzone.waypoint that <path id=\"...\" waypoints=\"poi1 poi2\"/> in the zone file "
      "names,\n"
      "in turn. sumo-gui shows what --debug-shapes writes: sumo-gui -c FILE -a POLYGONS,SHAPES.\n\n"
      "Exit codes: 0 done, 2 input at fault, 3 SUMO failed.");
  run_command->add_option("scenario", options.config, "SUMO configuration (.sumocfg)")->required();
  run_command->add_option("--zone", options.zone_file, "Zone file (.zone.xml)");
  run_command->add_option("--model", options.model,
                          "Walking model of every zone: " + allowed_models() +
                              " [default: the zone's, else heuristic]");
  run_command->add_option("--seed", options.seed, "Seed of SUMO and pedzone [default: SUMO's]");
  run_command->add_option("--end", options.end, "End time in s [default: the scenario's]")
      ->check(CLI::Range(0.0, 1e9));
  run_command->add_option("--threads", options.threads, "Threads for walking; 0: all cores")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  run_command->add_flag("--strict", options.strict,
                        "A scenario without persons or without shared space is an error; else it "
                        "runs as in SUMO, with a warning");
  run_command->add_flag("--quiet", options.quiet,
                        "No progress on the terminal and no summary; warnings and errors are told");
  run_command->add_option("--summary", options.summary,
                          "Write the summary as JSON; this and other outputs: - is standard "
                          "output, NAME.gz is compressed");
  auto* trajectories = run_command->add_option(
      "--trajectories", options.trajectories,
      fmt::format("Write {} of each person and step; NAME.sqlite: JuPedSim's database; NAME.txt: "
                  "PedPy's text, with NAME.ids.csv",
                  fmt::join(trajectory_table().names(), ",")));
  run_command
      ->add_option("--trajectories-of", options.trajectories_of,
                   "Whose, in NAME.sqlite and NAME.txt: zones: whom pedzone walks; all: whom SUMO "
                   "walks, too")
      ->check(CLI::IsMember({"zones", "all"}))
      ->capture_default_str()
      ->needs(trajectories);
  auto* edge_data = run_command->add_option(
      "--edge-data", options.edge_data,
      "Write density, speed and time loss of people by edges of the zones, as SUMO's edgeData");
  run_command
      ->add_option("--edge-data-period", options.edge_data_period,
                   "Seconds of an interval of those [default: the whole run]")
      ->check(CLI::Range(0.1, 1e9))
      ->needs(edge_data);
  run_command->add_option("--paths-svg", options.picture, "Draw people's paths over the zone");
  auto* shapes = run_command->add_option(
      "--debug-shapes", options.debug_shapes,
      "Write paths, waypoints and each person's aim, direction and free distances as SUMO shapes");
  run_command
      ->add_option("--debug-time", options.debug_time,
                   "Time in s of those shapes [default: the end of the run]")
      ->check(CLI::Range(0.0, 1e9))
      ->needs(shapes);
  add_conflict_options(*run_command, options.conflicts);
  add_panel_options(*run_command, options.panel);
  run_command->add_option("sumo_options", options.sumo_options, "-- and any options for SUMO");
  set_callback(*run_command, options, run, code);
}

void add_inspect(CLI::App& app, InspectOptions& options, int& code) {
  CLI::App* command =
      app.add_subcommand("inspect", "Show what would be controlled: numbers, warnings, a picture");
  command->footer("Example:\n  pedzone inspect town.sumocfg --svg zone.svg");
  command->add_option("scenario", options.config, "SUMO configuration (.sumocfg)")->required();
  command->add_option("--zone", options.zone_file, "Zone file (.zone.xml)");
  command->add_option("--svg", options.svg, "Draw the zone");
  command->add_option("sumo_options", options.sumo_options, "-- and any options for SUMO");
  set_callback(*command, options, inspect, code);
}

void add_parameters(CLI::App& app) {
  app.add_subcommand("parameters",
                     "Print the tables of a zone's parameters and of <pedestrians> (Markdown)")
      ->callback([] { fmt::print("{}", parameter_tables()); });
}

void add_profiles(CLI::App& app) {
  app.add_subcommand("profiles", "Print the tables of profiles, activities and weather (Markdown)")
      ->callback([] { fmt::print("{}", profile_tables()); });
}

void add_conflicts(CLI::App& app, ConflictsOptions& options, int& code) {
  CLI::App* command = app.add_subcommand(
      "conflicts", "Measure conflicts of persons and vehicles in SUMO's floating-car data");
  command->footer(
      "Examples:\n"
      "  sumo -c town.sumocfg --fcd-output fcd.xml.gz\n"
      "  pedzone conflicts fcd.xml.gz --scenario town.sumocfg --conflict-output conflicts.xml\n\n"
      "The same measures as `pedzone run --conflict-output`, whoever walked the persons. SUMO\n"
      "writes positions to 0.01 m; its option --precision 4 makes the measures smoother.\n"
      "Exit codes: 0 done, 2 input at fault.");
  command->add_option("fcd", options.fcd, "SUMO's fcd-output, gzipped or not")->required();
  command->add_option("--scenario", options.scenario,
                      "SUMO configuration whose files tell how large vehicles and persons are");
  command->add_option("--vtypes", options.types, "More route or additional files that tell it")
      ->allow_extra_args(false);
  command
      ->add_option("--treat-as-person", options.as_persons,
                   "Types of vehicles that count as persons, e.g. wheelchairs")
      ->allow_extra_args(false);
  add_conflict_options(*command, options.conflicts);
  command->callback([&options, &code] { code = conflicts(options); });
}

void add_demand(CLI::App& app, DemandOptions& options, int& code) {
  CLI::App* command = app.add_subcommand(
      "demand", "Write the people that `pedzone run` would make as a SUMO route file");
  command->footer(
      "Examples:\n"
      "  pedzone demand town.sumocfg --pedestrians 200 --seed 7 --out people.rou.xml\n"
      "  sumo -c town.sumocfg --additional-files people.rou.xml    # walked by SUMO's striping\n\n"
      "The same scenario, zone file, options and seed give the same people as in `pedzone run`, "
      "to\n"
      "the bit. On SUMO's command line --additional-files replaces those of the configuration:\n"
      "name them, too, where they matter. Profiles: `pedzone profiles`.\n"
      "Exit codes: 0 done, 2 input at fault.");
  command->add_option("scenario", options.config, "SUMO configuration (.sumocfg)")->required();
  command->add_option("--zone", options.zone_file, "Zone file (.zone.xml)");
  command->add_option("--seed", options.seed, "Seed [default: the scenario's, else SUMO's]");
  command->add_option("--out", options.out, "Route file to write")->required();
  add_panel_options(*command, options.panel);
  command->add_option("sumo_options", options.sumo_options, "-- and any options for SUMO");
  set_callback(*command, options, demand, code);
}

int command_line(int argc, char** argv) {
  CLI::App app{"pedzone walks the pedestrians of a SUMO simulation through shared space"};
  app.set_version_flag("--version", PEDZONE_VERSION);
  app.require_subcommand(1);
  RunOptions run_options;
  InspectOptions inspect_options;
  ConflictsOptions conflicts_options;
  DemandOptions demand_options;
  int code = 0;
  add_run(app, run_options, code);
  add_inspect(app, inspect_options, code);
  add_demand(app, demand_options, code);
  add_conflicts(app, conflicts_options, code);
  add_animate(app, code);
  add_geojson(app, code);
  add_parameters(app);
  add_profiles(app);
  add_plot(app, code);
  add_study(app, code);
  add_validate(app, code);
  add_calibrate(app, code);
  add_verify(app, code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    fmt::print(stderr, "Error: {}\n{}Run with --help to see what is allowed.\n", error.what(),
               hint_before(app.remaining(true)));
    return kExitInput;
  }
  return code;
}

}  // namespace
}  // namespace pedzone

int main(int argc, char** argv) { return pedzone::command_line(argc, argv); }
