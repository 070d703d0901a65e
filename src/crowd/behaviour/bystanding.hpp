// People who stand while others pass: they turn, and step back for who cannot get by.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Who has come, gone or been put elsewhere since the crowd last looked: crowd.seen becomes sorted
/// by key and crowd.seen_memory as long, in its order.
void recognise_seen(CrowdState& crowd);

/// After the moves of a substep of `dt` [s] are set: who stands, but for those whom others hold up,
/// and so may make a step, which `reach` [m], the longest move, then has to allow for.
void notice_standing(const CrowdState& crowd, double dt, Standing& standing, double& reach);

/// Once it is known who is near whom: who stands turns while others pass, and steps back for who is
/// held up, by its move. Writes the moves of those who stand, whom others pass, and how far the
/// seen have stepped.
void make_room(CrowdState& crowd, double dt);

/// After all have moved: how long the seen have stood, and where SUMO's next place will be.
void remember_seen(const CrowdState& crowd, double dt, std::vector<SeenMemory>& memory);

/// [m] Where the seen person k is for the crowd.
Vec2 own_place(const CrowdState& crowd, std::size_t k);

}  // namespace pedzone
