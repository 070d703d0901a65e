// Vehicles before zebra crossings: who is on one, or about to enter it, goes first.
#pragma once

#include <optional>
#include <span>

#include "sumo/plan/yield_plan.hpp"

namespace pedzone {

/// [m] that the front may drive up to the first zebra crossing, within `distance` [m] along its
/// way, that somebody uses who has not come past the vehicle's way yet, nor will be met before the
/// vehicle is over it. Nothing: it is before none.
std::optional<double> way_to_used_zebra(const FleetVehicle& vehicle,
                                        std::span<const PersonAhead> people, double distance);

}  // namespace pedzone
