#include "sumo/files/place_reader.hpp"

#include "core/xml_stream.hpp"
#include "zone/any_zones.hpp"
#include "zone/paths.hpp"
#include "zone/zone_file.hpp"

namespace pedzone {
namespace {

/// Of edges that have one. Walking does without: a network is read without them.
std::unordered_map<std::string, std::string> read_street_names(const std::string& net_file) {
  std::unordered_map<std::string, std::string> names;
  visit_elements(net_file, "net", [&](const XmlElement& element) {
    if (element.depth() != 1 || element.name() != "edge") return;
    const auto name = element.value("name");
    if (name && !name->empty()) names.emplace(element.required("id"), *name);
  });
  return names;
}

}  // namespace

Place read_place(const Scenario& scenario, const std::string& zone_file) {
  const ZoneFile file = zone_file.empty() ? ZoneFile{} : read_zone_file(zone_file);
  Place place;
  place.network = read_scenario_network(scenario);
  place.zones = build_any_zones(place.network, file.zones);
  place.paths = find_paths(place.network, place.zones, file.paths);
  place.street_names = read_street_names(scenario.net_file);
  return place;
}

}  // namespace pedzone
