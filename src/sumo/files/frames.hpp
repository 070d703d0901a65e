// SUMO's frames and ours: degrees clockwise from north ↔ radians counter-clockwise from +x.
#pragma once

#include "core/vec.hpp"

namespace pedzone {

inline double radians_from_sumo(double degrees) {
  return wrap_angle(0.5 * kPi - degrees * kPi / 180.0);
}

inline double sumo_from_radians(double radians) {
  const double degrees = 90.0 - radians * 180.0 / kPi;
  return degrees - 360.0 * std::floor(degrees / 360.0);
}

}  // namespace pedzone
