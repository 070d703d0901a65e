#include "app/run_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "app/command_line/common_options.hpp"
#include "app/command_line/values.hpp"
#include "results/trajectories.hpp"

namespace pedzone {
namespace {

constexpr const char* kWhatIsRun = "What is run";

}  // namespace

void add_walking_options(CLI::App& command, RunOptions& options) {
  const char* group = kWhatIsRun;
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
}

CLI::Validator a_port() { return whole_number_in(1, std::numeric_limits<std::uint16_t>::max()); }

CLI::Option* add_screenshots(CLI::App& command, RunOptions& options) {
  return command
      .add_option("--screenshots", options.screenshots,
                  "Have sumo-gui write a picture of each step: FOLDER/step-000000.png, ...")
      ->type_name(kFolder);
}

void add_process_options(CLI::App& command, RunOptions& options) {
  const char* group = "SUMO as a process of its own";
  auto* gui = command.add_flag("--gui", options.own.gui, "Show the run in sumo-gui")->group(group);
  command.add_option("--delay", options.own.delay, "Milliseconds between steps in sumo-gui")
      ->check(number_in(0, 10000))
      ->type_name("MILLISECONDS")
      ->capture_default_str()
      ->group(group)
      ->needs(gui);
  add_screenshots(command, options)->group(group)->needs(gui);
  auto* clients =
      command
          .add_option(
              "--clients", options.own.clients,
              "Number of your own TraCI clients. SUMO waits for them. Their orders are 1, 2, ...")
          ->check(whole_number_in(0, 100))
          ->type_name(kNumber)
          ->capture_default_str()
          ->group(group);
  command
      .add_option("--client", options.own.client,
                  "Shell command that starts a TraCI client of yours. {port} becomes SUMO's port")
      ->type_name("COMMAND")
      ->group(group)
      ->excludes(clients);
  command.add_option("--port", options.own.port, "Port at which SUMO waits for --clients")
      ->check(a_port())
      ->type_name(kNumber)
      ->default_str("8813")
      ->group(group)
      ->needs(clients);
}

void add_strict_flag(CLI::App& command, RunOptions& options) {
  command
      .add_flag("--strict", options.strict,
                "A scenario without persons or shared space is an error. Without this option, "
                "pedzone warns, and SUMO runs alone")
      ->group(kWhatIsRun);
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
                  "Which people NAME.sqlite and NAME.txt contain. zones: those that pedzone walks; "
                  "all: SUMO's too")
      ->check(one_of({"zones", "all"}))
      ->type_name(kNames)
      ->capture_default_str()
      ->group("Outputs")
      ->needs(trajectories);
  add("--crossing-output", options.crossings,
      "Write who crossed a street between junctions (crossing=\"anywhere\"): how long each "
      "waited, which gaps it took and which it let pass");
  auto* edge_data =
      add("--edge-data", options.edge_data,
          "Write density, speed and time loss of people on each edge of the zones, in the format "
          "of SUMO's edgeData");
  command
      .add_option("--edge-data-period", options.edge_data_period,
                  "Length of one interval of --edge-data")
      ->check(number_in(0.1, kLongestTime))
      ->type_name(kSeconds)
      ->default_str("the whole run")
      ->group("Outputs")
      ->needs(edge_data);
  add("--paths-svg", options.picture, "Draw people's paths over the zone");
  auto* shapes = add(
      "--debug-shapes", options.debug_shapes,
      "Write paths, waypoints and each person's aim, direction and free distances at one moment, "
      "as shapes for sumo-gui");
  command.add_option("--debug-time", options.debug_time, "The moment of --debug-shapes")
      ->check(number_in(0, kLongestTime))
      ->type_name(kSeconds)
      ->default_str("the end of the run")
      ->group("Outputs")
      ->needs(shapes);
}

}  // namespace pedzone
