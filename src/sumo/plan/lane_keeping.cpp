#include "sumo/plan/lane_keeping.hpp"

#include <algorithm>
#include <utility>

namespace pedzone {
namespace {

constexpr double kAside = 10.0;    // [m] numerical: more than two lanes are wide
constexpr double kStepsOut = 1.3;  // [m/s] assumed: of who stands between lanes
constexpr double kChange = 3.5;    // [s] numerical: SUMO's sublane model moves sideways at 1 m/s

/// A way from the rear on, and how wide [m] a body sweeps it.
struct Course {
  Polyline way;
  double width;
};

/// Whether its body would touch anybody on the course in this step, or before it can stop.
bool is_barred(const FleetVehicle& vehicle, Course course, std::span<const PersonAhead> people,
               double margin, double distance, double dt) {
  FleetVehicle moved;
  moved.traits = vehicle.traits;
  moved.traits.width = course.width;
  moved.front = point_on(course.way, vehicle.traits.length).point;
  moved.heading = vehicle.heading;
  moved.way = std::move(course.way);
  const VehicleBody body = body_of(moved);
  const auto touches = [&](const PersonAhead& person) {
    const double reach = person.radius + margin;
    return body.signed_distance(person.position) < reach ||
           body.signed_distance(person.position + person.velocity * dt) < reach;
  };
  return std::ranges::any_of(people, touches) ||
         first_in_way(moved, people, margin, distance).has_value();
}

/// What lies between the middles of its own way and of that beside it.
Course between(const FleetVehicle& vehicle, const Polyline& beside) {
  const Vec2 aside = point_on(beside, vehicle.traits.length).point - vehicle.front;
  Course strip{beside, aside.norm()};
  for (Vec2& point : strip.way) point -= 0.5 * aside;
  return strip;
}

}  // namespace

bool LaneKeeping::is_anybody_beside(const Fleet& fleet, const FleetVehicle& vehicle,
                                    const PeopleNear& all, double dt) const {
  const double soon = (vehicle.speed + vehicle.traits.accel * dt) * dt;
  // One that changes lanes bit by bit sweeps what is between them on its way.
  const bool drifts = vehicle.traits.drifts || vehicle.traits.sublanes;
  const double distance =
      soon + braking_distance(vehicle) + (drifts ? kChange * vehicle.speed : 0.0);
  const double reach = distance + vehicle.traits.length + kAside;
  const auto is_near = [&](const PersonAhead& person) {
    return (person.position - vehicle.front).squaredNorm() < reach * reach;
  };
  std::vector<PersonAhead> people = all.at(vehicle.front, reach + kAside);
  if (std::ranges::none_of(people, is_near)) return false;
  // They let those pass that drive on their lanes, and step out behind them.
  for (PersonAhead& person : people) person.radius += person.crosses ? kStepsOut * dt : 0.0;
  const double margin = zones_[vehicle.zone].parameters.yield_margin;
  std::vector<Polyline> ways = fleet.ways_beside(vehicle, soon, distance);
  const auto barred = [&](Course course) {
    return is_barred(vehicle, std::move(course), people, margin, distance, dt);
  };
  return std::ranges::any_of(ways, [&](Polyline& way) {
    return (drifts && barred(between(vehicle, way))) ||
           barred({std::move(way), vehicle.traits.width});
  });
}

std::vector<SpeedOrder> LaneKeeping::plan(const Fleet& fleet, const PeopleNear& people, double dt) {
  std::vector<SpeedOrder> orders;
  std::unordered_set<std::string> kept = std::exchange(keep_, {});
  for (const FleetVehicle& vehicle : fleet.vehicles()) {
    if (!gives_way(vehicle) || !is_anybody_beside(fleet, vehicle, people, dt)) continue;
    if (kept.erase(vehicle.id) == 0) orders.push_back({vehicle.id, LaneChanges::kNone});
    keep_.insert(vehicle.id);
  }
  std::vector<std::string> free(kept.begin(), kept.end());
  std::ranges::sort(free);  // the same calls in each run
  for (std::string& id : free) orders.push_back({std::move(id), LaneChanges::kOwn});
  return orders;
}

}  // namespace pedzone
