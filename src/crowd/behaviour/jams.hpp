// Jams of people, and how they come apart.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Share of its turned width that is left of somebody in that jam: 1 unless it squeezes.
float width_left(const JamMemory& jam);

/// After a substep of `dt` [s]: who lacked room among people and has not come 0.5 m nearer to its
/// goal for `jamTime` begins to squeeze, which makes it narrower the longer it takes, until it
/// walks freely again. Two who face each other do so after a twelfth of that time, and who has
/// squeezed a short way ago after a fifth. Adds those who begin to `notices`.
void notice_jams(const CrowdState& crowd, double dt, ByHandle<JamMemory>& jams,
                 std::vector<JamNotice>& notices);

}  // namespace pedzone
