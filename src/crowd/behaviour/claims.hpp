// Room for vehicles that people hold up: those in the way step out of it, those beside it wait.
//
// Where the claims of two vehicles meet, somebody may neither stay in the one nor step into the
// other, and would hold up both for ever. So vehicles have their turns. Who has claimed room for
// longest is first. A person in its room is not held back by the claims of those after it.
#pragma once

#include <optional>

#include "crowd/sense/claim_room.hpp"
#include "crowd/sense/side_room.hpp"
#include "crowd/state/state.hpp"

namespace pedzone {

/// Lists the vehicles that claim room, in the order of their turns; of two that have claimed it
/// equally long, the one with the lower key is first.
void order_claims(const CrowdState& crowd, std::vector<std::uint32_t>& claimants);

/// Who stands in a claim steps out of it. Bends where the person goes otherwise: to be called after
/// all other proposals.
void propose_ways_out_of_claims(const CrowdState& crowd, Proposals& proposals);

/// Who is beside a claim and would step into it waits there.
void restrain_beside_claims(const CrowdState& crowd, Restraints& restraints);

/// [m] that row i leaves between its centre and the sides of a vehicle that claims room.
double room_beside_claims(const CrowdState& crowd, std::size_t i);

/// Whether the claim and the body of a vehicle are out of reach: cheap and generous.
bool far_from(const VehicleState& vehicle, const Vec2& point);

/// Calls visit(vehicle, place) for the claims near row i that it minds, in the order of their
/// turns. `place`: where it is in the claimed room; nothing where it is not in it. The first claim
/// that it is in, or that it holds up from beside, is the last one that it minds.
template <class Visit>
void visit_claims(const CrowdState& crowd, std::size_t i, const Visit& visit) {
  const Vec2 here = crowd.position(i);
  const double margin = room_beside_claims(crowd, i);
  for (const std::uint32_t v : crowd.claimants) {
    const VehicleState& vehicle = crowd.vehicles[v];
    if (far_from(vehicle, here)) continue;
    const std::optional<ClaimPlace> place = place_in_claim(vehicle, here, margin);
    visit(vehicle, place);
    if (place || holds_up(vehicle, here, crowd.persons.radius[i])) return;
  }
}

/// Whether row i is in the vehicle's claim and finds room to step out of it with straight
/// shoulders.
bool can_leave_claim(const CrowdState& crowd, std::size_t i, const VehicleState& vehicle);

}  // namespace pedzone
