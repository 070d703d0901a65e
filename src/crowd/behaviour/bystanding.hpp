// People who stand while others pass: they turn, and step back for who cannot get by.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Who has come, gone or been put elsewhere since the crowd last looked. Sorts `seen` by key, and
/// makes `memory` as long, in the same order. `before` becomes what `memory` was.
void recognise_seen(std::vector<SeenPerson>& seen, std::vector<SeenMemory>& memory,
                    std::vector<SeenMemory>& before);

/// After the moves of a substep of `dt` [s] are set: who stands, and not because others hold it up.
/// Such a person may make a step: `reach` [m], the longest move, becomes at least as long.
void notice_standing(const CrowdState& crowd, double dt, Standing& standing, double& reach);

/// Once it is known who is near whom: who stands turns while others pass, and steps back for who is
/// held up. Writes the moves of those who stand, which of the walked are `passed`, and how the seen
/// have turned and stepped.
void make_room(const CrowdState& crowd, double dt, std::vector<std::uint8_t>& passed,
               std::vector<SeenMemory>& seen_memory, Moves& moves);

/// After all have moved: how long the seen have stood, and where SUMO's next place will be.
void remember_seen(const CrowdState& crowd, double dt, std::vector<SeenMemory>& memory);

/// [m] Where the seen person k is for the crowd.
Vec2 own_place(const CrowdState& crowd, std::size_t k);

}  // namespace pedzone
