// Vehicles that people have held, and others in a junction: each took its turn by how the other
// drove.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sumo/plan/yield_plan.hpp"

namespace pedzone {

/// Those inside a junction that drive, or that people hold.
std::vector<const FleetVehicle*> in_junctions(std::span<const FleetVehicle> vehicles);

/// The first of those `inside` that drives through the junction that `vehicle` comes to or is in,
/// and would be touched by its body as both go on, the other for 2 s; looked for as far as it needs
/// to stop, and 1 s. SUMO's vehicles enter by when the others were to come; one that people held
/// and let go comes at another time. Nothing where neither was told a speed in the last 5 s: they
/// are SUMO's matter. Of two that are both inside, the one waits that stands, else the one that has
/// farther to go: nobody for one that stands.
std::optional<Obstruction> first_in_junction(const FleetVehicle& vehicle,
                                             std::span<const FleetVehicle* const> inside);

}  // namespace pedzone
