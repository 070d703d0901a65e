#include "app/inspect.hpp"

#include <memory>

#include "app/command_line/common_options.hpp"
#include "app/command_line/sumo_words.hpp"
#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/inspect_json.hpp"
#include "crowd/zone_models.hpp"
#include "results/complete_file.hpp"
#include "sumo/files/hint_values.hpp"
#include "sumo/files/scenario.hpp"
#include "view/zone_report.hpp"
#include "view/zone_svg.hpp"
#include "zone/any_zones.hpp"

namespace pedzone {
namespace {

struct InspectOptions {
  std::string config;                     ///< .sumocfg
  std::string zone_file;                  ///< empty: the zone is found by itself
  std::string svg;                        ///< picture to write; empty: none
  bool json = false;                      ///< instead of text
  std::vector<std::string> sumo_options;  ///< what stands after `--`
};

void report(const InspectOptions& options) {
  const Scenario scenario = read_scenario(options.config, options.sumo_options);
  ZoneFile file;
  if (!options.zone_file.empty()) file = read_zone_file(options.zone_file);
  std::unique_ptr<CompleteFile> picture;
  if (!options.svg.empty()) picture = std::make_unique<CompleteFile>(options.svg, "--svg");
  const Network network = read_scenario_network(scenario);
  const std::vector<Zone> zones = build_any_zones(network, with_models(file.zones));
  const std::vector<WaypointPath> paths = find_paths(network, zones, file.paths);
  require_known_hints(scenario, {file.profiles, paths});
  if (picture) {
    picture->write(zone_svg(network, zones));
    picture->finish();
  }
  if (options.json) {
    print_text(inspect_json(network, zones));
  } else {
    print_result(zone_report(network, zones));
  }
}

int inspect(const InspectOptions& options) {
  return guarded([&] { report(options); });
}

}  // namespace

void add_inspect(CLI::App& app, int& code) {
  const auto options = std::make_shared<InspectOptions>();
  CLI::App* command = app.add_subcommand(
      "inspect", "Show the zones that pedzone would control: numbers, warnings, a picture");
  command->footer("Example:\n  pedzone inspect town.sumocfg --svg zone.svg");
  add_scenario(*command, options->config, options->zone_file);
  command->add_option("--svg", options->svg, "Draw the zone")->type_name(kFile);
  add_json_flag(*command, options->json);
  add_sumo_words(*command, options->sumo_options);
  set_callback(*command, options, inspect, code);
}

}  // namespace pedzone
