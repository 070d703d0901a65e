// Jams of people, and how they come apart.
#pragma once

#include "crowd/state.hpp"

namespace pedzone {

/// Share of its turned width that is left of somebody in that jam: 1 unless it squeezes.
float width_left(const Jam& jam);

/// After a substep of `dt` [s]: who lacked room among people and has not come 0.5 m nearer to its
/// goal for `jamTime` begins to squeeze, which makes it narrower the longer it takes, until it
/// walks freely again. Adds those who begin to crowd.jams.
void notice_jams(CrowdState& crowd, double dt);

}  // namespace pedzone
