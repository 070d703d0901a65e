// The vehicles of a scenario that vehicle paths steer.
#pragma once

#include <vector>

#include "sumo/files/scenario.hpp"
#include "zone/vehicle_path.hpp"

namespace pedzone {

/// Throws InputError for a path of a vehicle that the scenario's route and additional files do not
/// name. "flow.12" is of a flow with the id "flow".
void require_vehicles(const Scenario& scenario, const std::vector<VehiclePath>& paths);

}  // namespace pedzone
