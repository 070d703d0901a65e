// When vehicles come to a place of a street, and how many do.
#pragma once

#include "crowd/state/street_traffic.hpp"
#include "world/snapshot.hpp"
#include "zone/streets.hpp"

namespace pedzone {

/// [s] until a vehicle that drives `distance` [m] farther has done so; infinity for one that
/// stands. One that is slow may speed up.
double time_to_drive(const StreetVehicle& vehicle, double distance);

/// The vehicle of that place in the crowd's list on a street: s of its front, t of its middle [m],
/// `direction` 1 along the axis, -1 against it; it covers `width` [m] of t.
StreetVehicle as_seen(const VehicleState& vehicle, std::uint32_t index, double front, double t,
                      double width, int direction);

/// Finds the vehicles of each street, and keeps count of their flow for a substep of `dt` [s].
void observe_streets(const std::vector<Street>& streets, const std::vector<VehicleState>& vehicles,
                     double dt, std::vector<StreetTraffic>& traffic);

}  // namespace pedzone
