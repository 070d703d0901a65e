#include "sumo/plan/lane_end.hpp"

#include <algorithm>
#include <optional>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

// [m] left before the lane's end for who comes or leaves: SUMO lets nobody walk on who is less than
// 5 m before a vehicle, and takes people back 3 m before the end at most.
constexpr double kRoom = 8.0;
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

/// [m] from the vehicle's rear to its lane's end; nothing where its way does not go so far.
std::optional<double> way_to_end(const FleetVehicle& vehicle) {
  const double way = vehicle.traits.length + vehicle.tight_end;
  return way > length_of(vehicle.way) ? std::nullopt : std::optional(way);
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
  const auto way = way_to_end(vehicle);
  if (!way) return false;
  const LinePoint end = point_on(vehicle.way, *way);
  return std::ranges::any_of(outside,
                             [&](const PersonAhead& person) { return wants_in(person, end); });
}

bool goes_out(const FleetVehicle& vehicle, std::span<const PersonAhead> people) {
  const auto way = way_to_end(vehicle);
  if (!way) return false;
  return std::ranges::any_of(people, [&](const PersonAhead& person) {
    if (person.exit_lane != vehicle.lane) return false;
    const double at = project_on(vehicle.way, person.position).offset;
    return at > vehicle.traits.length && at > *way - kRoom;
  });
}

}  // namespace pedzone
