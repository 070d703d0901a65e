#include "python/python_zone.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sumo/files/net_reader.hpp"
#include "sumo/files/scenario.hpp"
#include "verify/ground.hpp"
#include "world/model_names.hpp"
#include "zone/any_zones.hpp"

namespace pedzone {
namespace {

Network network_of(const std::string& file) {
  if (file.ends_with(".net.xml") || file.ends_with(".net.xml.gz")) return read_network(file);
  return read_scenario_network(read_scenario(file, {}));
}

void set_parameter(const std::string& key, double value, Parameters& parameters) {
  const ParameterInfo* info = find_parameter(key);
  if (info == nullptr) {
    throw InputError("is no parameter",
                     {.element = "parameters",
                      .value = key,
                      .allowed = comma_list(parameter_list(), &ParameterInfo::key)});
  }
  if (!(value >= info->least && value <= info->most)) {  // no number: refused, too
    throw InputError("is out of range",
                     {.element = "parameter " + key,
                      .value = fmt::format("{}", value),
                      .allowed = fmt::format("{} to {} {}", info->least, info->most, info->unit)});
  }
  parameters.*info->member = value;
}

}  // namespace

std::vector<SharedZone> read_zones(const std::string& scenario, const std::string& zone_file) {
  ZoneFile file;
  if (!zone_file.empty()) file = read_zone_file(zone_file);
  const auto profiles = std::make_shared<const Profiles>(std::move(file.profiles));
  std::vector<SharedZone> zones;
  for (Zone& zone : build_any_zones(network_of(scenario), file.zones)) {
    zones.push_back(std::make_shared<PythonZone>(PythonZone{std::move(zone), profiles}));
  }
  return zones;
}

SharedZone zone_of_polygons(const Ring& outer, const std::vector<Ring>& holes,
                            const ZoneWishes& wishes) {
  if (!may_be_model(wishes.model)) {
    throw InputError("is no walking model",
                     {.element = "model", .value = wishes.model, .allowed = allowed_models()});
  }
  Region ground = repair(outer);
  for (const Ring& hole : holes) ground = subtract(ground, repair(hole));
  if (ground.empty()) {
    throw InputError("has no ground", {.element = "zone '" + wishes.id + "'",
                                       .allowed = "a polygon of at least three corners [m]"});
  }
  Zone zone = verify::zone_of(ground, wishes.model);
  zone.id = wishes.id;
  for (const auto& [key, value] : wishes.parameters) set_parameter(key, value, zone.parameters);
  return std::make_shared<PythonZone>(
      PythonZone{std::move(zone), std::make_shared<const Profiles>()});
}

}  // namespace pedzone
