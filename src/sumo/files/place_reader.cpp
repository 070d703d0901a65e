#include "sumo/files/place_reader.hpp"

#include "zone/any_zones.hpp"
#include "zone/paths.hpp"
#include "zone/zone_file.hpp"

namespace pedzone {

Place read_place(const Scenario& scenario, const std::string& zone_file) {
  const ZoneFile file = zone_file.empty() ? ZoneFile{} : read_zone_file(zone_file);
  Place place;
  place.network = read_scenario_network(scenario);
  place.zones = build_any_zones(place.network, file.zones);
  place.paths = find_paths(place.network, place.zones, file.paths);
  return place;
}

}  // namespace pedzone
