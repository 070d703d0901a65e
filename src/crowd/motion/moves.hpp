// From decisions to the displacement that each body means to make.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Velocities, headings and meant displacements of a substep of `dt` [s], and which walkers wait.
void set_moves(const CrowdState& crowd, double dt, std::vector<WalkState>& walkers,
               Persons& persons, Moves& moves);

}  // namespace pedzone
