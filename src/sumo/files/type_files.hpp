// What a scenario's files tell of people and vehicles: sizes, speeds, profiles, groups.
#pragma once

#include <string>
#include <vector>

#include "sumo/files/scenario.hpp"

namespace pedzone {

/// A Reader (RecordingCast, BodySizes, DesiredSpeeds, WalkSpeeds) that has read the scenario's
/// additional and route files, and then `more` files. Throws InputError.
template <class Reader>
Reader read_type_files(const Scenario& scenario, const std::vector<std::string>& more = {}) {
  Reader reader;
  for (const auto* files : {&scenario.additional_files, &scenario.route_files, &more}) {
    for (const std::string& file : *files) reader.read(file);
  }
  return reader;
}

/// The same of a SUMO configuration; empty: none. `sumo_options` win over it.
template <class Reader>
Reader read_type_files(const std::string& scenario, const std::vector<std::string>& sumo_options,
                       const std::vector<std::string>& more) {
  return read_type_files<Reader>(
      scenario.empty() ? Scenario{} : read_any_scenario(scenario, sumo_options), more);
}

}  // namespace pedzone
