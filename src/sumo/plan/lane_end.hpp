// Lane ends at which SUMO's people come into a zone. SUMO lets nobody past a vehicle that leaves
// less than a stripe of its lane free, and stops the vehicle for whoever stands before it: both
// wait for ever.
#pragma once

#include <span>

#include "sumo/plan/yield_plan.hpp"
#include "zone/network.hpp"

namespace pedzone {

/// Whether SUMO lets nobody past the vehicle on that lane, which people share, and there is room
/// for it to wait before the lane's end: its whole body, in a straight piece of the lane.
bool leaves_no_stripe(const Lane& lane, const VehicleTraits& traits);

/// [m] from the front to where the vehicle leaves one of SUMO's people room to come onto its lane,
/// where pedzone walks it on; below 0 once it is past that.
double way_to_room(const FleetVehicle& vehicle);

/// Whether one of those whom SUMO walks may want in at the lane's end: waits there, or comes.
bool comes_in(const FleetVehicle& vehicle, std::span<const PersonAhead> outside);

}  // namespace pedzone
