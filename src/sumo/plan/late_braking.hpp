// How hard a vehicle must brake for people who stepped in late, and those behind it.
#pragma once

#include <span>

#include "sumo/plan/vehicle.hpp"

namespace pedzone {

struct PersonAhead;

/// [m/s²] The least braking, kept up to the standstill, with which neither the vehicle's front nor
/// a flank that swings in a bend touches any of `people` if they walk on as they do: the type's
/// decel where that is enough, its emergency_decel where nothing is. `dt` [s]: of the step, in
/// which SUMO drives at one speed. Who walks against the vehicle's side is not helped by braking
/// and does not count.
double needed_deceleration(const FleetVehicle& vehicle, std::span<const PersonAhead> people,
                           double dt);

/// [m/s²] The least braking, kept up to the standstill, with which the vehicle keeps its min_gap to
/// its leader, now `gap` [m] ahead, if that drives at `next` [m/s] in this step of `dt` [s] and
/// then brakes as it likes to: the type's decel where that is enough or the gap is too short
/// already, its emergency_decel where nothing is.
double needed_deceleration_behind(const FleetVehicle& vehicle, double gap,
                                  const VehicleTraits& leader, double next, double dt);

}  // namespace pedzone
