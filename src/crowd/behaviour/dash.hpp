// Impulsive people now and then run in front of a vehicle.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Who runs already, and who begins within a substep of `dt` [s].
void begin_dashes(const CrowdState& crowd, double dt, ByHandle<ActivityMemory>& activities);

/// To where the front of the nearest vehicle will be, which the person does not mind meanwhile.
void propose_dashes(const CrowdState& crowd, Proposals& proposals, Attention& attention);

}  // namespace pedzone
