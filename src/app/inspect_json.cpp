#include "app/inspect_json.hpp"

#include "app/json_text.hpp"
#include "view/zone_report.hpp"

namespace pedzone {
namespace {

nlohmann::ordered_json types_json(const std::vector<TypeLength>& types) {
  auto json = nlohmann::ordered_json::array();
  for (const TypeLength& entry : types) {
    json.push_back({{"type", entry.type}, {"edges", entry.edges}, {"length_m", entry.length}});
    if (!entry.bring_in.empty()) json.back()["brought_in_by"] = entry.bring_in;
  }
  return json;
}

nlohmann::ordered_json zone_json(const Network& network, const Zone& zone) {
  const ZoneFigures figures = figures_of(network, zone);
  return {{"id", zone.id},
          {"model", zone.model},
          {"edges", zone.edges.size()},
          {"length_m", figures.length},
          {"lanes", zone.lanes.size()},
          {"crossings", figures.crossings},
          {"walkable_m2", figures.surface},
          {"parts", zone.walkable.size()},
          {"walls", zone.walls.walls().size()},
          {"types", types_json(zone.inside)},
          {"warnings", zone.warnings}};
}

}  // namespace

std::string inspect_json(const Network& network, const std::vector<Zone>& zones) {
  nlohmann::ordered_json json = {{"version", kJsonVersion},
                                 {"network", network.file},
                                 {"zones", nlohmann::ordered_json::array()}};
  for (const Zone& zone : zones) json["zones"].push_back(zone_json(network, zone));
  json["left_to_sumo"] = types_json(left_to_sumo(network, zones));
  json["warnings"] = network.warnings;
  return json_text(json);
}

}  // namespace pedzone
