// What a scenario's files tell of people and vehicles: sizes, profiles, groups.
#pragma once

#include <string>
#include <vector>

#include "sumo/files/scenario.hpp"

namespace pedzone {

/// A Reader (RecordingCast, BodySizes) that has read the scenario's additional and route files, and
/// then `more` files. `scenario`: SUMO configuration, empty: none; `sumo_options` win over it.
/// Throws InputError.
template <class Reader>
Reader read_type_files(const std::string& scenario, const std::vector<std::string>& sumo_options,
                       const std::vector<std::string>& more) {
  Reader reader;
  if (!scenario.empty()) {
    const Scenario found = read_any_scenario(scenario, sumo_options);
    for (const std::string& file : found.additional_files) reader.read(file);
    for (const std::string& file : found.route_files) reader.read(file);
  }
  for (const std::string& file : more) reader.read(file);
  return reader;
}

}  // namespace pedzone
