// What people do beside walking: texting, chatting, sitting down.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Activities begin and end along a substep of `dt` [s], by their rates and durations.
void carry_on_activities(const CrowdState& crowd, double dt, ByHandle<ActivityMemory>& activities);

/// Who goes to sit down goes to its seat.
void propose_seats(const CrowdState& crowd, Proposals& proposals);

/// Who chats or sits stands, unless a vehicle makes it step aside.
void restrain_by_activity(const CrowdState& crowd, Restraints& restraints);

}  // namespace pedzone
