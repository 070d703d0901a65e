// Narrow streets: who is in a vehicle's way steps aside, shoulders turned, where there is room for
// the vehicle to drive past; where there is none, it goes past the vehicle, which waits for it.
#pragma once

#include <vector>

#include "crowd/state/state.hpp"

namespace pedzone {

/// Replaces the decisions of those who step aside for a vehicle that claims room, stand there, or
/// go past one that stands or creeps. To be called after all restraints: it is a matter of
/// centimetres, and models choose among directions some degrees apart and keep more to walls and
/// vehicles.
void step_aside(const CrowdState& crowd, std::vector<Decision>& decisions);

}  // namespace pedzone
