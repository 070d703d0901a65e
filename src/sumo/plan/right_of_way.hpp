// Vehicles before zebra crossings: who is on one, or about to enter it, goes first.
#pragma once

#include <optional>
#include <span>

#include "sumo/plan/yield_plan.hpp"

namespace pedzone {

/// [m] from the front to the first zebra crossing that somebody uses, within `distance` [m] along
/// the way. Nothing where there is none. Left out: people who have passed the vehicle's way, and
/// crossings that the vehicle clears before the person arrives.
std::optional<double> way_to_used_zebra(const FleetVehicle& vehicle,
                                        std::span<const PersonAhead> people, double distance);

}  // namespace pedzone
