// Which waypoint of its route each person heads for, and whether it has arrived.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Once everybody is where a substep of `dt` [s] has brought it: who goes on to the next waypoint,
/// plans anew, loses patience or has arrived. Writes routes, paths, and what walkers tell of both.
void follow_waypoints(CrowdState& crowd, double dt);

}  // namespace pedzone
