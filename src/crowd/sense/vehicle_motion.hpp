// A vehicle's place: its rectangle, and how that moves on within a step.
#pragma once

#include "geometry/polyline.hpp"
#include "geometry/rectangle.hpp"
#include "world/snapshot.hpp"

namespace pedzone {

/// The vehicle's body when its rear is `travelled` [m] along its way: a chord of that, so that
/// corners are cut as SUMO draws them. The way must not be empty.
Rectangle body_on_way(const VehicleState& vehicle, double travelled);

/// The same for places on its way that do not fall, each from where the last one was.
class BodyOnWay {
 public:
  explicit BodyOnWay(const VehicleState& vehicle)
      : vehicle_(vehicle), rear_(vehicle.way), front_(vehicle.way) {}
  Rectangle at(double travelled);

 private:
  const VehicleState& vehicle_;
  LineWalk rear_, front_;
};

/// The vehicle `dt` [s] later, its speed held. Along its way where that is known and the vehicle is
/// on it. Else the yaw rate is held, too: the velocity turns with the body, and the centre moves
/// along the velocity half-way through the turn (exact for straight lines, second order in the
/// turned angle otherwise).
VehicleState moved_on(const VehicleState& vehicle, double dt);

/// Its body `ahead` [m] farther along its way than it is; < 0: behind.
Rectangle body_shifted(const VehicleState& vehicle, double ahead);

/// The body of a standing vehicle once it has driven off by `ahead` [m], or to the end of its way.
Rectangle body_if_started(const VehicleState& vehicle, double ahead);

/// The part of a standing vehicle's body beside which people stand now, once it has driven off by
/// `ahead` [m]: on a bend it cuts the corner.
Rectangle flanks_if_started(const VehicleState& vehicle, double ahead);

inline Rectangle rectangle_of(const VehicleState& vehicle) {
  return {vehicle.centre, unit(vehicle.heading), {0.5 * vehicle.length, 0.5 * vehicle.width}};
}

/// The middle of its front bumper.
inline Vec2 front_of(const VehicleState& vehicle) {
  return vehicle.centre + unit(vehicle.heading) * (0.5 * vehicle.length);
}

/// Distance [m] from a point to the vehicle's rectangle; 0 inside.
inline double distance_to(const VehicleState& vehicle, const Vec2& point) {
  return rectangle_of(vehicle).distance(point);
}

}  // namespace pedzone
