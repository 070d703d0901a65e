// Who turns the shoulders, and how wide bodies are then.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Sets how wide everybody is in the substep of `dt` [s], once it is known who is near whom: as
/// narrow as can be who lacks room by its decision (whatever model made it), whom others kept from
/// moving in the substep before, and who stands while others go past. Others straighten within
/// `turnTime`, and no more than there is room for: straightening pushes nobody.
void hold_shoulders(CrowdState& crowd, double dt);

}  // namespace pedzone
