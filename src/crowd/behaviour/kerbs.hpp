// Crosswalks: who has no priority waits at the kerb for a gap.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Whether row i comes to a kerb where it may have to wait, within the next `way` [m].
bool comes_to_kerb(const CrowdState& crowd, std::size_t i, double way);

/// The crosswalk, from where row i comes, that it is on or looks across at the kerb, without having
/// to wait there. Nothing: none.
std::optional<Crosswalk> crosswalk_used(const CrowdState& crowd, std::size_t i);

/// Who has to wait, in a substep of `dt` [s].
void look_at_kerbs(const CrowdState& crowd, double dt, ByHandle<KerbMemory>& kerbs);

/// They do.
void restrain_at_kerbs(const CrowdState& crowd, Restraints& restraints);

}  // namespace pedzone
