#include "sumo/plan/lane_end.hpp"

#include <algorithm>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kStripe = 0.65;    // [m] SUMO's pedestrian.striping.stripe-width, as it is set
constexpr double kRoom = 6.0;       // [m] assumed: left before the lane's end for who comes
constexpr double kWaits = 8.0;      // [m] assumed: so far beyond the end people are who want in
constexpr double kAway = 0.5;       // numerical: cos of 60 degrees
constexpr double kStraight = 0.98;  // numerical: cos of 11 degrees

/// Whether somebody is beyond the lane's end and does not walk away from it.
bool wants_in(const PersonAhead& person, const LinePoint& end) {
  const Vec2 beyond = person.position - end.point;
  if (beyond.norm() > kWaits || beyond.dot(end.direction) < 0.0) return false;
  const double speed = person.velocity.norm();
  return speed < kHaltingSpeed || person.velocity.dot(beyond) < kAway * speed * beyond.norm();
}

}  // namespace

bool leaves_no_stripe(const Lane& lane, const VehicleTraits& traits) {
  if (!lane.persons || lane.width - traits.width >= 2.0 * kStripe) return false;
  const double length = length_of(lane.shape), rear = length - kRoom - traits.length;
  if (rear < 0.0) return false;
  // In a bend it would stand across the street.
  const Vec2 begin = point_on(lane.shape, rear).direction,
             end = point_on(lane.shape, length).direction;
  return begin.dot(end) > kStraight;
}

double way_to_room(const FleetVehicle& vehicle) { return vehicle.tight_end - kRoom; }

bool comes_in(const FleetVehicle& vehicle, std::span<const PersonAhead> outside) {
  const double way = vehicle.traits.length + vehicle.tight_end;
  if (way > length_of(vehicle.way)) return false;
  const LinePoint end = point_on(vehicle.way, way);
  return std::ranges::any_of(outside,
                             [&](const PersonAhead& person) { return wants_in(person, end); });
}

}  // namespace pedzone
