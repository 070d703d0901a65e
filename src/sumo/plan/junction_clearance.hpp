// Vehicles that people have held, and others in a junction: each took its turn by how the other
// drove.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sumo/plan/yield_plan.hpp"

namespace pedzone {

/// Those so far inside a junction that they are in the way of others.
std::vector<const FleetVehicle*> in_junctions(std::span<const FleetVehicle> vehicles);

/// The first of those `inside` that has to be let go first in the junction that `vehicle` comes to
/// or is in, and would be touched by its body as both go on; its distance is that which the vehicle
/// may go. SUMO's vehicles enter by when the others were to come; one that people held and let go
/// comes at another time. Nothing where neither was told a speed in the last 5 s: they are SUMO's
/// matter.
/// Who is outside looks as far as its way out of the junction, and at all of the way of one that
/// drives or that people hold: it waits at its line, if it can, since SUMO lets it come in and
/// stand where the other is yet to pass. Of two that are both inside, the one waits that stands,
/// else the one that has farther to go, for where the other gets to within 2 s. For the body alone
/// of one that stands, unless it is itself in the way of that one.
std::optional<Obstruction> first_in_junction(const FleetVehicle& vehicle,
                                             std::span<const FleetVehicle* const> inside);

}  // namespace pedzone
