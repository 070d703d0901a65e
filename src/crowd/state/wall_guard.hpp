// Keeps bodies inside the walls, cheaply where no wall is near.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/wall_index.hpp"

namespace pedzone {

/// What is known of the distance from a body's place to the nearest wall.
struct WallRoom {
  double distance = 0.0;  ///< [m] a lower bound of it
  bool measured = false;  ///< just looked up: looking again would tell no more

  /// After the body has moved by `way` [m].
  void spend(double way) {
    distance -= way;
    measured = false;
  }
};

/// Distance [m] from `point` to the nearest wall, at most `reach` [m]. `scratch` is overwritten.
double wall_distance(const WallIndex& walls, const Vec2& point, double reach,
                     std::vector<std::uint32_t>& scratch);

/// Where a body of `radius` [m] at `from` gets to that wants to be at `to`. `room` is that of
/// `from`: walls are looked up only where it does not suffice.
Vec2 kept_inside(const WallIndex& walls, const Vec2& from, const Vec2& to, double radius,
                 WallRoom& room, std::vector<std::uint32_t>& scratch);

}  // namespace pedzone
