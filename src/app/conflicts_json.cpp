#include "app/conflicts_json.hpp"

#include "app/json_text.hpp"
#include "results/conflict_table.hpp"

namespace pedzone {
namespace {

nlohmann::ordered_json extreme_json(const Extreme& extreme) {
  return {{"value", extreme.value},
          {"time", extreme.time},
          {"x", extreme.position.x()},
          {"y", extreme.position.y()},
          {"type", name_of(extreme.type)},
          {"personSpeed", extreme.person_speed},
          {"vehicleSpeed", extreme.vehicle_speed},
          {"relativeSpeed", extreme.relative_speed},
          {"closingSpeed", extreme.closing_speed}};
}

nlohmann::ordered_json conflict_json(const Conflict& conflict) {
  nlohmann::ordered_json json = {
      {"person", conflict.person},      {"vehicle", conflict.vehicle},
      {"begin", conflict.begin},        {"end", conflict.end},
      {"type", name_of(conflict.type)}, {"first", name_of(conflict.first)}};
  if (conflict.aware) json["aware"] = *conflict.aware;
  for (const ConflictMeasure& measure : kConflictMeasures) {
    if (const auto& extreme = conflict.*measure.extreme)
      json[measure.name] = extreme_json(*extreme);
  }
  for (const auto& [name, meaning, reaction] : reactions_of(conflict)) {
    if (reaction) json[name] = {{"value", reaction->value}, {"time", reaction->time}};
  }
  return json;
}

nlohmann::ordered_json crossings_json(const CrossingNumbers& numbers) {
  nlohmann::ordered_json json = {{"all", numbers.all}, {"between", numbers.between}};
  if (numbers.between == 0) return json;
  json["waited_s"] = numbers.waited;
  json["near_conflicts"] = numbers.near;
  json["far_conflicts"] = numbers.far;
  if (const auto& fit = numbers.gaps) {
    json["gap"] = {{"median_s", fit->median},
                   {"low_s", fit->low},
                   {"high_s", fit->high},
                   {"taken", fit->taken},
                   {"rejected", fit->left}};
  }
  return json;
}

}  // namespace

std::string conflicts_json(const std::vector<Conflict>& conflicts,
                           const std::optional<CrossingNumbers>& crossings) {
  nlohmann::ordered_json json = {{"version", kJsonVersion},
                                 {"conflicts", nlohmann::ordered_json::array()}};
  for (const Conflict& conflict : conflicts) json["conflicts"].push_back(conflict_json(conflict));
  if (crossings) json["crossings"] = crossings_json(*crossings);
  return json_text(json);
}

}  // namespace pedzone
