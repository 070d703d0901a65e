// Along the route: what people do while nothing else matters.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Where row i goes by its route, its heading varied as it is now; who has arrived stays.
Wish wish_of_route(const CrowdState& crowd, std::size_t i);

/// Varies everybody's heading for a substep of `dt` [s], and proposes its route.
void propose_way(const CrowdState& crowd, double dt, std::vector<WalkState>& walkers,
                 Proposals& proposals);

}  // namespace pedzone
