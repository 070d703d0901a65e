#include "app/inspect.hpp"

#include <fmt/format.h>

#include <memory>

#include "app/guarded.hpp"
#include "results/complete_file.hpp"
#include "sumo/files/hint_values.hpp"
#include "sumo/files/scenario.hpp"
#include "view/zone_report.hpp"
#include "view/zone_svg.hpp"
#include "zone/any_zones.hpp"

namespace pedzone {
namespace {

void report(const InspectOptions& options) {
  const Scenario scenario = read_scenario(options.config, options.sumo_options);
  ZoneFile file;
  if (!options.zone_file.empty()) file = read_zone_file(options.zone_file);
  std::unique_ptr<CompleteFile> picture;
  if (!options.svg.empty()) picture = std::make_unique<CompleteFile>(options.svg, "--svg");
  const Network network = read_scenario_network(scenario);
  const std::vector<Zone> zones = build_any_zones(network, file.zones);
  const std::vector<WaypointPath> paths = find_paths(network, zones, file.paths);
  require_known_hints(scenario, {file.profiles, paths});
  if (picture) {
    picture->write(zone_svg(network, zones));
    picture->finish();
  }
  fmt::print("{}", zone_report(network, zones));
}

}  // namespace

int inspect(const InspectOptions& options) {
  return guarded([&] { report(options); });
}

}  // namespace pedzone
