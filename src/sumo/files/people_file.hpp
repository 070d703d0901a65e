// The people of a scenario's panels as a SUMO route file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "demand/people.hpp"
#include "sumo/files/scenario.hpp"

namespace pedzone {

struct PeopleFileInput {
  const Scenario& scenario;
  const Network& network;
  const std::vector<Zone>& zones;
  const Profiles& profiles;
  const std::vector<PanelSpec>& panels;
  std::optional<std::uint64_t> seed;  ///< unset: SUMO's
};

/// The file's text; the same for the same input. Throws InputError as plan_people().
std::string people_file(const PeopleFileInput& input);

}  // namespace pedzone
