// Bodies and vehicles do not overlap.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Moves every walked person whose body (at crowd.moves.x, y) would be within a small gap of
/// where a vehicle will be in `dt` [s] out of its way, never through a wall.
void keep_out_of_vehicles(const CrowdState& crowd, double dt, std::vector<VehicleHit>& hits,
                          Moves& moves);

}  // namespace pedzone
