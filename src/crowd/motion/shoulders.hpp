// Who turns the shoulders, and how wide bodies are then.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Sets everybody's width for a substep of `dt` [s], once it is known who is near whom. As narrow
/// as possible: who lacks room by its decision, whom others pressed in the last substep, who stands
/// while others pass. All others straighten within `turnTime`, as far as there is room: that pushes
/// nobody. `next_radius` [m] holds the new widths until all are known.
void hold_shoulders(const CrowdState& crowd, double dt, std::vector<WalkState>& walkers,
                    std::vector<double>& next_radius, Persons& persons);

}  // namespace pedzone
