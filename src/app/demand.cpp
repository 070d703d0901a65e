#include "app/demand.hpp"

#include "app/guarded.hpp"
#include "results/complete_file.hpp"
#include "sumo/files/people_file.hpp"

namespace pedzone {
namespace {

void write(const DemandOptions& options) {
  const Scenario scenario = read_scenario(options.config, options.sumo_options);
  const ZoneFile zone_file = read_zone_file(options.zone_file, options.panel);
  if (zone_file.panels.empty()) {
    throw InputError("asks for nobody",
                     {options.zone_file, 0, "pedzone demand", "",
                      "--pedestrians N, or <pedestrians> elements in the zone file"});
  }
  CompleteFile out(options.out, "--out");
  const Network network = read_scenario_network(scenario);
  const std::vector<Zone> zones = build_zones(network, zone_file.zones);
  out.write(
      people_file({scenario, network, zones, zone_file.profiles, zone_file.panels, options.seed}));
  out.finish();
}

}  // namespace

int demand(const DemandOptions& options) {
  return guarded([&] { write(options); });
}

}  // namespace pedzone
