// From decisions to the displacement that each body means to make.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Velocities, headings and meant displacements of a substep of `dt` [s], and who waits. Writes
/// crowd.persons, crowd.moves and the walkers' `waits`.
void set_moves(CrowdState& crowd, double dt);

}  // namespace pedzone
