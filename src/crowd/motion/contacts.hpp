// All bodies move at once, and those that would overlap are kept apart.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Sorts all places into `grid`, and lists for every walked person the bodies that it may touch
/// within the substep.
void find_neighbours(const CrowdState& crowd, BodyGrid& grid, Neighbourhood& near);

/// Moves everybody as meant, as far as the walls let them: to crowd.moves.x, y.
void move_freely(CrowdState& crowd);

/// Pushes apart those who overlap there: writes crowd.moves.x, y, and who was pressed.
void settle_contacts(CrowdState& crowd);

/// Of these pushes only those between bodies with the shoulders turned all the way. Returns whether
/// there were any.
bool settle_cores(CrowdState& crowd);

/// Puts everybody where it got to; crowd.moves.x, y then tell where it was. Writes places and
/// velocities.
void commit(CrowdState& crowd);

}  // namespace pedzone
