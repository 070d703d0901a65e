// What one person perceives, put together by hand. The person is at the origin and walks east.
#pragma once

#include "geometry/segment.hpp"
#include "model/perceived.hpp"
#include "model/vehicle_sweep.hpp"

namespace pedzone::test {

inline Perceived person() {
  static const Parameters parameters;
  Perceived who;
  who.velocity = Vec2(1.34, 0.0);
  who.heading = who.goal_direction = Vec2(1.0, 0.0);
  who.goal_distance = 50.0;
  who.radius = 0.24;
  who.width = 1.0;
  who.speed = 1.34;
  who.caution = 1.0;
  who.step = 0.1;
  who.key = 1;
  who.seed = 1;
  who.parameters = &parameters;
  return who;
}

inline Neighbour neighbour(const Vec2& offset, const Vec2& velocity = Vec2::Zero(),
                           double radius = 0.24) {
  return {offset, velocity, radius, offset.norm()};
}

/// `inward`: unit vector to the walkable side.
inline Border border(const Vec2& a, const Vec2& b, const Vec2& inward) {
  const Vec2 nearest = nearest_on(a, b, Vec2::Zero());
  return {nearest, a, b, inward, nearest.norm(), false};
}

/// A car of 5 m by 1.8 m whose centre is at `centre`.
inline SeenVehicle vehicle_seen(const Vec2& centre, double heading, double speed) {
  SeenVehicle vehicle;
  vehicle.centre = centre;
  vehicle.axis = unit(heading);
  vehicle.velocity = speed * vehicle.axis;
  vehicle.half_length = 2.5;
  vehicle.half_width = 0.9;
  vehicle.moving = speed > 0.0;
  const SweepDistance now = distance_to(sweep_of(vehicle, 0.0), Vec2::Zero());
  vehicle.distance = now.distance;
  vehicle.away = now.away;
  vehicle.nearest = -now.distance * now.away;
  return vehicle;
}

}  // namespace pedzone::test
