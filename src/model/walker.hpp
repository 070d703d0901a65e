// One person while it decides, in the numbers that the kernel works with.
#pragma once

#include <cmath>

#include "model/fixed_point.hpp"

namespace pedzone {

/// How far and wide a person perceives.
struct Senses {
  float sight = 10.0F;                       ///< [m]
  float vehicle_sight = 10.0F;               ///< [m] of moving vehicles
  float hearing = 8.0F;                      ///< [m] of moving vehicles outside the field of view
  double field_of_view = 90.0;               ///< [deg] half angle
  float field_cos = 0.0F, field_sin = 1.0F;  ///< of that
};

struct Walker {
  LatticePoint at;
  double heading = 0.0;  ///< [rad] [-pi, pi]
  float heading_cos = 1.0F, heading_sin = 0.0F;
  float vx = 0.0F, vy = 0.0F;                                  ///< [m/s]
  float pace() const { return std::sqrt(vx * vx + vy * vy); }  ///< [m/s]
  float radius = 0.24F;                                        ///< [m]
  float turned_radius = 0.12F;                                 ///< [m] with its shoulders turned
  float speed = 1.34F;                                         ///< [m/s] preferred
  float static_reach = 10.0F;  ///< [m] what stands farther away than this does not count
};

}  // namespace pedzone
