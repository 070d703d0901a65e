#include "sumo/plan/vehicle.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone {

double Body::distance(const Vec2& point) const {
  const Vec2 to = point - centre;
  const double along = std::abs(to.dot(axis)) - half_length;
  const double across = std::abs(cross(axis, to)) - half_width;
  if (along <= 0.0 && across <= 0.0) return std::max(along, across);
  return std::hypot(std::max(along, 0.0), std::max(across, 0.0));
}

Body body_of(const FleetVehicle& vehicle) {
  return {vehicle.centre(), unit(vehicle.heading), 0.5 * vehicle.traits.length,
          0.5 * vehicle.traits.width};
}

Body body_after(const FleetVehicle& vehicle, double travelled) {
  if (vehicle.way.size() < 2 || travelled <= 0.0) return body_of(vehicle);
  const Vec2 rear = point_on(vehicle.way, travelled).point;
  const Vec2 front = point_on(vehicle.way, travelled + vehicle.traits.length).point;
  const Vec2 along = front - rear;
  const double chord = along.norm();
  const Vec2 axis = chord > 0.1 ? Vec2(along / chord) : unit(vehicle.heading);
  return {front - axis * (0.5 * vehicle.traits.length), axis, 0.5 * vehicle.traits.length,
          0.5 * vehicle.traits.width};
}

}  // namespace pedzone
