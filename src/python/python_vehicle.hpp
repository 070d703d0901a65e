// A vehicle as Python holds it.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "world/snapshot.hpp"

namespace pedzone {

/// With the way that its state only refers to.
struct PythonVehicle {
  VehicleState state;
  std::vector<Vec2> way;  ///< [m]
};

/// What a crowd takes. Refers to the ways of `vehicles`. Throws std::invalid_argument for a number
/// that is not finite and for a size that is not positive.
std::vector<VehicleState> states_of(const std::vector<PythonVehicle>& vehicles);

PythonVehicle vehicle_of(const VehicleState& state);

}  // namespace pedzone
