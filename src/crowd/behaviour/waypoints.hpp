// Which waypoint of its route each person heads for, and whether it has arrived.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Once everybody is where `dt` [s] have brought it, a substep or a step of so many `substeps`: who
/// goes on to the next waypoint, plans anew, loses patience or has arrived.
void follow_waypoints(const CrowdState& crowd, double dt, std::uint64_t substeps, Ways ways);

}  // namespace pedzone
