// Bodies and vehicles do not overlap.
#pragma once

#include "crowd/state.hpp"

namespace pedzone {

/// Moves every walked person whose body (at crowd.motion.x, y) would be within a small gap of
/// where a vehicle will be in `dt` [s] out of its way, never through a wall.
void keep_out_of_vehicles(CrowdState& crowd, double dt);

/// Distance [m] from a point to the vehicle's rectangle; 0 inside.
double distance_to(const VehicleState& vehicle, const Vec2& point);

}  // namespace pedzone
