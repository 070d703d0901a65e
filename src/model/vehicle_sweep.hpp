// The room that a vehicle takes within the next seconds: its rectangle, stretched along its way.
#pragma once

#include "core/vec.hpp"
#include "model/perceived.hpp"

namespace pedzone {

/// [s] Assumed: persons mind the room that a moving vehicle takes within this time. The models
/// that read it come from papers without vehicles; it is the Δt of Helbing and Molnár (1995), by
/// which they stretch a walking person.
inline constexpr double kSweepTime = 2.0;

/// A rectangle relative to the person.
struct VehicleSweep {
  Vec2 centre;                     ///< [m]
  Vec2 axis;                       ///< unit vector along half_length
  double half_length, half_width;  ///< [m]
  bool moving;                     ///< else it is only where it is
};

/// The rectangle that the vehicle covers within `time` [s] ≥ 0 if it drives straight on.
inline VehicleSweep sweep_of(const SeenVehicle& vehicle, double time) {
  const double along = vehicle.velocity.dot(vehicle.axis) * time;
  return {vehicle.centre + vehicle.axis * (along / 2.0), vehicle.axis,
          vehicle.half_length + std::abs(along) / 2.0, vehicle.half_width, along != 0.0};
}

/// How far [m] a point is from the sweep and in which direction that grows fastest (unit vector).
/// Inside the distance is negative, and the way out leads through the nearest side; out of a moving
/// vehicle's way to the left or right, since it would catch up with whoever runs ahead of it.
struct SweepDistance {
  double distance;
  Vec2 away;
};

inline SweepDistance distance_to(const VehicleSweep& sweep, const Vec2& point) {
  const Vec2 p = point - sweep.centre;
  const Vec2 left = left_of(sweep.axis);
  const double x = p.dot(sweep.axis), y = p.dot(left);
  const double out_x = std::abs(x) - sweep.half_length, out_y = std::abs(y) - sweep.half_width;
  const Vec2 along = x < 0.0 ? Vec2(-sweep.axis) : sweep.axis;
  const Vec2 aside = y < 0.0 ? Vec2(-left) : left;
  if (out_x > 0.0 && out_y > 0.0) {
    const double distance = std::hypot(out_x, out_y);
    return {distance, (out_x * along + out_y * aside) / distance};
  }
  const bool inside = out_x <= 0.0 && out_y <= 0.0;
  return out_x > out_y && !(inside && sweep.moving) ? SweepDistance{out_x, along}
                                                    : SweepDistance{out_y, aside};
}

}  // namespace pedzone
