// The place of a scenario, from its files.
#pragma once

#include <string>

#include "results/place.hpp"
#include "sumo/files/scenario.hpp"

namespace pedzone {

/// Network, zones and paths of waypoints. `zone_file`: empty where zones are found by themselves.
/// Throws InputError.
Place read_place(const Scenario& scenario, const std::string& zone_file);

}  // namespace pedzone
