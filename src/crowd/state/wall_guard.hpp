// Keeps bodies inside the walls, cheaply where no wall is near.
#pragma once

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

/// A body of `radius` [m] at `from` wants to be at `to`: where it gets to. `room` is that around
/// `from`. Walls are looked up only where that is too little, and `room` is then measured anew.
Vec2 kept_inside(const WallIndex& walls, const Vec2& from, const Vec2& to, double radius,
                 WallRoom& room);

}  // namespace pedzone
