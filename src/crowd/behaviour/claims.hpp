// Room for vehicles that people hold up: those in the way step out of it, those beside it wait.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Who stands in a claim steps out of it. Bends where the person goes otherwise: to be called after
/// all other proposals.
void propose_ways_out_of_claims(const CrowdState& crowd, Proposals& proposals);

/// Who is beside a claim and would step into it waits there.
void restrain_beside_claims(const CrowdState& crowd, Restraints& restraints);

/// [m] that row i leaves between its centre and the sides of a vehicle that claims room.
double room_beside_claims(const CrowdState& crowd, std::size_t i);

/// Whether row i is in the vehicle's claim and finds no room to step out of it with straight
/// shoulders.
bool lacks_wide_side(const CrowdState& crowd, std::size_t i, const VehicleState& vehicle);

}  // namespace pedzone
