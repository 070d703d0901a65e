// A vehicle's place: its rectangle, and how that moves on within a step.
#pragma once

#include "geometry/rectangle.hpp"
#include "world/snapshot.hpp"

namespace pedzone {

/// The vehicle `dt` [s] later: speed and yaw rate held. The velocity turns with the body, and the
/// centre moves along the velocity half-way through the turn (exact for straight lines, second
/// order in the turned angle otherwise).
inline VehicleState moved_on(const VehicleState& vehicle, double dt) {
  const auto turned = [](const Vec2& v, double angle) -> Vec2 {
    const Vec2 e = unit(angle);
    return {v.x() * e.x() - v.y() * e.y(), v.x() * e.y() + v.y() * e.x()};
  };
  VehicleState later = vehicle;
  const double angle = vehicle.yaw_rate * dt;
  later.centre += turned(vehicle.velocity, 0.5 * angle) * dt;
  later.velocity = turned(vehicle.velocity, angle);
  later.heading = wrap_angle(vehicle.heading + angle);
  return later;
}

inline Rectangle rectangle_of(const VehicleState& vehicle) {
  return {vehicle.centre, unit(vehicle.heading), {0.5 * vehicle.length, 0.5 * vehicle.width}};
}

/// Distance [m] from a point to the vehicle's rectangle; 0 inside.
inline double distance_to(const VehicleState& vehicle, const Vec2& point) {
  return rectangle_of(vehicle).distance(point);
}

}  // namespace pedzone
