#include "crowd/sense/vehicle_motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pedzone {
namespace {

constexpr double kChord = 0.1;      // [m] numerical: shorter ones have no direction
constexpr double kOnWay = 0.02;     // [m] numerical: a vehicle on its way is that near to it
constexpr double kStanding = 1e-3;  // [m/s] numerical
constexpr double kAhead = 0.5;      // [m] numerical: where its front is going to

Vec2 turned(const Vec2& v, double angle) {
  const Vec2 e = unit(angle);
  return {v.x() * e.x() - v.y() * e.y(), v.x() * e.y() + v.y() * e.x()};
}

/// [m] that the rear has gone along the way; nothing where the vehicle is not on it.
std::optional<double> rear_on_way(const VehicleState& vehicle) {
  if (vehicle.way.size() < 3) return std::nullopt;
  const Vec2 expected = point_on(vehicle.way, vehicle.gone + vehicle.length).point;
  if ((front_of(vehicle) - expected).norm() > kOnWay) return std::nullopt;
  return vehicle.gone;
}

/// [m/s] of the middle of its front bumper.
Vec2 front_velocity(const VehicleState& vehicle) {
  const double swings = 0.5 * vehicle.length * vehicle.yaw_rate;
  return vehicle.velocity + left_of(unit(vehicle.heading)) * swings;
}

/// The same of one that drives forwards, as its middle or its front tells: in a sharp bend the
/// middle of a body that follows its front as a chord goes backwards.
std::optional<double> place_on_way(const VehicleState& vehicle) {
  const auto rear = rear_on_way(vehicle);
  if (!rear || (vehicle.forwards && vehicle.velocity.norm() >= kStanding)) return rear;
  if (vehicle.velocity.dot(unit(vehicle.heading)) >= kStanding) return rear;
  const double front = *rear + vehicle.length;
  const Vec2 ahead =
      point_on(vehicle.way, front + kAhead).point - point_on(vehicle.way, front).point;
  const bool forwards = front_velocity(vehicle).dot(ahead) >= kStanding * kAhead;
  return forwards ? rear : std::nullopt;
}

/// [m] that the rear of one that is `rear` [m] along its way has gone `ahead` [m] on; nothing where
/// its front is beyond the way's end then. There is nothing to be beyond where it leaves.
std::optional<double> farther_on_way(const VehicleState& vehicle, double rear, double ahead) {
  const double last = length_of(vehicle.way) - vehicle.length;
  if (rear + ahead <= last) return rear + ahead;
  return vehicle.leaves ? std::optional(std::max(rear, last)) : std::nullopt;
}

}  // namespace

Rectangle body_on_way(const VehicleState& vehicle, double travelled) {
  return BodyOnWay(vehicle).at(travelled);
}

Rectangle BodyOnWay::at(double travelled) {
  const Vec2 rear = rear_.to(travelled).point;
  const LinePoint front = front_.to(travelled + vehicle_.length);
  const Vec2 along = front.point - rear;
  const double chord = along.norm();
  const Vec2 axis = chord > kChord ? Vec2(along / chord) : front.direction;
  return {front.point - axis * (0.5 * vehicle_.length),
          axis,
          {0.5 * vehicle_.length, 0.5 * vehicle_.width}};
}

VehicleState moved_on(const VehicleState& vehicle, double dt) {
  VehicleState later = vehicle;
  later.lag += vehicle.slower * dt;
  later.lead = std::max(0.0, vehicle.lead - vehicle.velocity.norm() * dt);
  if (const auto rear = place_on_way(vehicle)) {
    if (const auto travelled = farther_on_way(vehicle, *rear, vehicle.velocity.norm() * dt)) {
      const Rectangle body = body_on_way(vehicle, *travelled);
      later.gone = *travelled;
      later.centre = body.centre;
      later.heading = angle_of(body.axis);
      later.velocity = turned(vehicle.velocity, later.heading - vehicle.heading);
      return later;
    }
  }
  const double angle = vehicle.yaw_rate * dt;
  later.centre += turned(vehicle.velocity, 0.5 * angle) * dt;
  later.velocity = turned(vehicle.velocity, angle);
  later.heading = wrap_angle(vehicle.heading + angle);
  return later;
}

Rectangle body_shifted(const VehicleState& vehicle, double ahead) {
  // One that drives forwards may go on even where it is expected to stand.
  const auto rear = vehicle.forwards ? rear_on_way(vehicle) : place_on_way(vehicle);
  const auto travelled = rear ? farther_on_way(vehicle, *rear, ahead) : std::nullopt;
  if (travelled) return body_on_way(vehicle, std::max(0.0, *travelled));
  Rectangle body = rectangle_of(vehicle);
  const double speed = vehicle.velocity.norm();
  if (speed > kStanding) body.centre += vehicle.velocity * (ahead / speed);
  return body;
}

Rectangle body_if_started(const VehicleState& vehicle, double ahead) {
  const auto rear = rear_on_way(vehicle);
  const double most = rear ? length_of(vehicle.way) - *rear - vehicle.length : 0.0;
  const double way = std::min(ahead, most);
  return way > 0.0 ? body_on_way(vehicle, *rear + way) : rectangle_of(vehicle);
}

Rectangle flanks_if_started(const VehicleState& vehicle, double ahead) {
  Rectangle body = body_if_started(vehicle, std::min(ahead, vehicle.length));
  const Vec2 front = body.centre + body.axis * body.half.x();
  const double way = (front - front_of(vehicle)).norm();
  body.centre -= body.axis * (0.5 * way);
  body.half.x() -= 0.5 * way;
  return body;
}

}  // namespace pedzone
