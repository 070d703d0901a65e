// Vehicles that turn: on a bend the rear swings out over ground beside them, or behind.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Who would step to where a rear is about to swing waits until it has passed, where standing
/// leaves more room and no vehicle comes.
void restrain_beside_rears(const CrowdState& crowd, Restraints& restraints);

}  // namespace pedzone
