// A vehicle on its way, for tests of how it meets people.
#pragma once

#include "sumo/plan/vehicle.hpp"

namespace pedzone::test {

/// A shuttle 4 m long and 2 m wide with its front at the origin, on its way along `ahead`.
inline FleetVehicle shuttle(const Polyline& ahead) {
  FleetVehicle vehicle;
  vehicle.traits.length = 4.0;
  vehicle.traits.width = 2.0;
  vehicle.way = {{-4.0, 0.0}, {0.0, 0.0}};
  vehicle.way.insert(vehicle.way.end(), ahead.begin(), ahead.end());
  return vehicle;
}

}  // namespace pedzone::test
