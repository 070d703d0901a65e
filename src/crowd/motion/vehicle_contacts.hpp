// Bodies make way for vehicles as far as they can.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// [m/s] assumed: faster nobody steps out of a vehicle's way, and no vehicle moves anybody. Two
/// steps a second of 1.5 m.
inline constexpr double kSteppingSpeed = 3.0;

/// Moves every walked person whose body (at moves.x, y) would be within a small gap of where a
/// vehicle will be in `dt` [s] out of its way, never through a wall and by at most kSteppingSpeed
/// in the whole substep. Holds people back from where it may be otherwise (VehicleState's lead, lag
/// and starts). Adds to `pushes` what each vehicle that drives did, by person and vehicle.
/// Returns whether anybody was moved.
bool keep_out_of_vehicles(const CrowdState& crowd, double dt, Moves& moves,
                          std::vector<VehiclePush>& pushes);

}  // namespace pedzone
