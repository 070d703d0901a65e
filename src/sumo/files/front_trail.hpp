// Where a vehicle's front has been, by which its parts follow: files tell of the front alone.
#pragma once

#include <vector>

#include "geometry/rectangle.hpp"
#include "world/vehicle_parts.hpp"

namespace pedzone {

class FrontTrail {
 public:
  /// Its front is at that place [m] for the first time, the vehicle of `length` [m] straight behind
  /// it in its heading [rad].
  void begin(const Vec2& front, double heading, double length);
  /// Its front has come to that place [m] by a smooth way.
  void go_to(const Vec2& front);
  bool begun() const { return !fronts_.empty(); }
  const Vec2& front() const { return fronts_.back(); }  ///< [m] once it has begun

  /// The parts now, the first first: each a chord of the trail.
  std::vector<Rectangle> parts(const VehicleParts& parts, double width) const;

 private:
  std::vector<Vec2> backwards() const;

  double length_ = 0.0;       ///< [m]
  std::vector<Vec2> fronts_;  ///< [m] the latest last
};

}  // namespace pedzone
