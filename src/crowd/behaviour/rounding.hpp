// Vehicles that stand in somebody's way.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Who gets no further before a vehicle that stands goes round it, with all its parts and what
/// stands so close to it that nobody gets between, by the corner that makes the shorter way: bends
/// the way that would win without it. To be called after all behaviours that are less important.
void propose_ways_round_vehicles(const CrowdState& crowd, Proposals& proposals);

}  // namespace pedzone
