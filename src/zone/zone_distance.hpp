// How far a place is at least from a zone: coarse and quick, so that who is far away need not be
// looked at in every step.
#pragma once

#include <vector>

#include "zone/zone.hpp"

namespace pedzone {

class ZoneDistance {
 public:
  explicit ZoneDistance(const Zone& zone);

  /// A lower bound [m] of the distance from a point to the zone's walkable area; never less than
  /// half of it by more than 20 m, or three cells where the area is so large that these are larger.
  double at_least(const Vec2& point) const;

 private:
  int column(double x) const;
  int row(double y) const;

  Vec2 low_ = Vec2::Zero(), high_ = Vec2::Zero();  ///< [m] bounds of the walkable area
  double cell_ = 0.0;                              ///< [m]
  int columns_ = 0, rows_ = 0;
  std::vector<int> steps_;  ///< per cell: moves of a chess king to the nearest cell of the area
};

}  // namespace pedzone
