// All bodies move at once, and those that would overlap are kept apart.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Sorts all places into `grid`, and lists for every walked person the bodies that it may touch
/// within the substep.
void find_neighbours(const CrowdState& crowd, BodyGrid& grid, Neighbourhood& near);

/// Lists nobody for anybody: all walk freely.
void forget_neighbours(const CrowdState& crowd, Neighbourhood& near);

/// Moves everybody as meant, as far as the walls let them: to moves.x, y. Of the walkers it writes
/// `wall_room`, as all that moves bodies does.
void move_freely(const CrowdState& crowd, std::vector<WalkState>& walkers, Moves& moves);

/// Pushes apart those who overlap there, and notes who is pressed.
void settle_contacts(const CrowdState& crowd, std::vector<WalkState>& walkers, Moves& moves);

/// Of these pushes only those between bodies with the shoulders turned all the way. Returns whether
/// there were any.
bool settle_cores(const CrowdState& crowd, std::vector<WalkState>& walkers, Moves& moves);

/// Puts everybody where it got to, and takes from its velocity what others stopped. moves.x, y then
/// tell where it was.
void commit(const CrowdState& crowd, std::vector<WalkState>& walkers, Persons& persons,
            Moves& moves);

}  // namespace pedzone
