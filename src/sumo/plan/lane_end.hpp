// Lane ends at which people come into a zone or leave it. SUMO lets nobody past a vehicle that
// leaves less than a stripe of its lane free, nor on within 5 m before it, and stops the vehicle
// for whoever stands before it: both wait for ever.
#pragma once

#include <span>

#include "sumo/plan/yield_plan.hpp"
#include "zone/network.hpp"

namespace pedzone {

inline constexpr double kStripe =
    0.65;  ///< [m] SUMO's pedestrian.striping.stripe-width, as it is set

/// Whether SUMO lets nobody past the vehicle on that lane, which people share, and there is room
/// for it to wait before the lane's end: its whole body, in a straight piece of the lane.
bool leaves_no_stripe(const Lane& lane, const VehicleTraits& traits);

/// [m] from the front to where the vehicle leaves people room before the lane's end: one of SUMO's
/// to come onto the lane, where pedzone walks it on, or one that SUMO takes back there; below 0
/// once it is past that.
double way_to_room(const FleetVehicle& vehicle);

/// Whether one of those whom SUMO walks may want in at the lane's end: waits there, or comes.
bool comes_in(const FleetVehicle& vehicle, std::span<const PersonAhead> outside);

/// Whether one of those whom pedzone walks is in that room and leaves the zone there.
bool goes_out(const FleetVehicle& vehicle, std::span<const PersonAhead> people);

}  // namespace pedzone
