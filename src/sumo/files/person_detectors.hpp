// Detectors that are to count people.
#pragma once

#include <string>
#include <vector>

#include "sumo/files/scenario.hpp"

namespace pedzone {

/// Ids of detectors, and of edge and lane data, in a scenario's additional files that say which
/// people they count (SUMO's `detectPersons`). Throws InputError.
std::vector<std::string> person_detectors(const Scenario& scenario);

}  // namespace pedzone
