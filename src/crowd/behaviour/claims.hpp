// Room for vehicles that people hold up: those in the way step out of it, those beside it wait.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Who stands in a claim steps out of it. Bends where the person goes otherwise: to be called after
/// all other proposals.
void propose_ways_out_of_claims(const CrowdState& crowd, Proposals& proposals);

/// Who is beside a claim and would step into it waits there.
void restrain_beside_claims(const CrowdState& crowd, Restraints& restraints);

}  // namespace pedzone
