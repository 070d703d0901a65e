// When vehicles come to a place of a street, and how many do.
#pragma once

#include "crowd/state/street_traffic.hpp"
#include "world/snapshot.hpp"
#include "zone/streets.hpp"

namespace pedzone {

/// [s] until a vehicle that drives `distance` [m] farther has done so; infinity for one that
/// stands. One that is slow may speed up.
double time_to_drive(const StreetVehicle& vehicle, double distance);

/// Finds the vehicles of each street, and keeps count of their flow for a substep of `dt` [s].
void observe_streets(const std::vector<Street>& streets, const std::vector<VehicleState>& vehicles,
                     double dt, std::vector<StreetTraffic>& traffic);

}  // namespace pedzone
