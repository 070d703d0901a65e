// Which vehicles come over a crosswalk, and when.
#pragma once

#include <span>
#include <vector>

#include "crowd/state/street_traffic.hpp"
#include "world/snapshot.hpp"
#include "zone/crosswalks.hpp"

namespace pedzone {

/// Vehicles whose way leads over the crosswalk, but for those that give way there: s is to the left
/// of the line from its begin to its end, t along it. Where their way is unknown: those that drive
/// straight over it.
std::vector<StreetVehicle> coming_over(const Crosswalk& crosswalk,
                                       std::span<const VehicleState> vehicles);

}  // namespace pedzone
