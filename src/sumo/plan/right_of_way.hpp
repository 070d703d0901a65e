// Vehicles before crossings at which they give way: who is on one, or about to enter it, goes
// first.
#pragma once

#include <optional>
#include <span>

#include "sumo/plan/yield_plan.hpp"

namespace pedzone {

/// [m] from the front to the first crossing that somebody uses and at which the vehicle gives way,
/// within `distance` [m] along the way: zebra crossings, and others by where it turns. Nothing
/// where there is none. Left out: people who have passed the vehicle's way, and crossings that the
/// vehicle clears before the person arrives; but for zebra crossings all, once it has stood for 10
/// s.
std::optional<double> way_to_used_crosswalk(const FleetVehicle& vehicle,
                                            std::span<const PersonAhead> people, double distance);

}  // namespace pedzone
