// Whether the paths that a scenario's persons and types name are there: known before SUMO starts,
// with file and line.
#pragma once

#include "sumo/scenario.hpp"
#include "zone/paths.hpp"

namespace pedzone {

/// The parameter of a person or vType that names its path.
constexpr const char* kPathKey = "pedzone.path";

/// Throws InputError for a <param key="pedzone.path"> in a route or additional file of the scenario
/// that names none of `paths`.
void require_known_paths(const Scenario& scenario, const std::vector<WaypointPath>& paths);

}  // namespace pedzone
