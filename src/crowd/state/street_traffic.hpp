// Vehicles on the streets that people may cross.
#pragma once

#include <cstdint>
#include <vector>

namespace pedzone {

/// A vehicle on its way along a street, or to it.
struct StreetVehicle {
  std::uint32_t vehicle = 0;     ///< in the crowd's list
  double front = 0.0;            ///< [m] s of its front bumper; off the street: as if the axis
                                 ///< went on to it
  double length = 0.0;           ///< [m]
  double speed = 0.0;            ///< [m/s]
  double low = 0.0, high = 0.0;  ///< [m] t that its body covers
  int direction = 1;             ///< 1: drives along the axis

  /// [m] from its front bumper to s; negative: past it.
  double distance_to(double s) const { return (s - front) * direction; }
};

/// Of one street.
struct StreetTraffic {
  std::vector<StreetVehicle> vehicles;  ///< in the order of the crowd's
  double flow = 0.0;      ///< [1/s] of vehicles, both directions, as who knows the street expects
  double observed = 0.0;  ///< [s] for how long that was counted
};

}  // namespace pedzone
