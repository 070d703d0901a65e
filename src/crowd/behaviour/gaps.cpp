#include "crowd/behaviour/gaps.hpp"

#include <algorithm>
#include <cmath>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kBeside = 0.3;    // [m] assumed: nobody lets a car pass nearer
constexpr double kAlong = 0.5;     // [m] assumed: and none stop nearer to the line
constexpr double kPast = 0.1;      // [m] assumed: gap to one that is parked
constexpr double kTouch = 0.1;     // [m] assumed: nobody stands nearer to where a car drives
constexpr double kAfter = 0.2;     // [s] assumed: after it has passed
constexpr double kOnTheWay = 0.3;  // [s] assumed: margin of who has stepped before vehicles
constexpr double kReaction = 1.5;  // [s] assumed: of a driver who sees somebody step out
constexpr double kPrepared = 0.7;  // [s] assumed: ... whom it has seen stand on the carriageway
constexpr double kComfort = 2.5;   // [m/s²] assumed: that it brakes with
constexpr double kLongestWait = 3600.0;  // [s] numerical: an hour is for ever

/// When the body is within the width that a vehicle covers, at most.
struct Inside {
  double enter, leave;  ///< [s] from now on; leave < 0: it is past it already
};

Inside inside(const CrossingWalk& walk, const StreetVehicle& vehicle) {
  const double room = walk.radius + kBeside;
  const double side = walk.to > walk.from ? 1.0 : -1.0;
  const double near = side > 0.0 ? vehicle.low - room : -(vehicle.high + room);
  const double far = side > 0.0 ? vehicle.high + room : -(vehicle.low - room);
  const double here = side * walk.from;
  const double enter = near <= here ? 0.0 : (near - here) / walk.speed;  // at the earliest
  return {enter, far <= here ? -1.0 : walk.start_up + (far - here) / walk.speed};
}

/// How far it has to drive.
struct Ahead {
  double front, rear;  ///< [m] until it comes to the body, and has passed it; negative: has
};

/// One that stands is in the way of a line that drifts where the line is once the body gets there.
Ahead ahead_of_standing(const CrossingWalk& walk, const StreetVehicle& vehicle) {
  const double across = walk.to - walk.from, reach = walk.radius + kPast;
  const auto line_at = [&](double t) {
    const double share = across != 0.0 ? std::clamp((t - walk.from) / across, 0.0, 1.0) : 0.0;
    return vehicle.distance_to(walk.s + share * walk.drift);
  };
  const auto [near, far] =
      std::minmax({line_at(vehicle.low - walk.radius), line_at(vehicle.high + walk.radius)});
  return {near - reach, far + vehicle.length + reach};
}

Ahead ahead(const CrossingWalk& walk, const StreetVehicle& vehicle) {
  if (vehicle.speed < kStaticSpeed) return ahead_of_standing(walk, vehicle);
  const double reach = walk.radius + kAlong;
  const double front = vehicle.distance_to(walk.s) - reach;
  return {front, front + vehicle.length + 2.0 * reach};
}

/// Whether it drives beyond where the walk ends: a refuge.
bool is_beyond(const CrossingWalk& walk, const StreetVehicle& vehicle) {
  return walk.to > walk.from ? vehicle.low > walk.to : vehicle.high < walk.to;
}

/// Whether the body is in the way already, or so nearly that there is no standing before it.
bool is_in_the_way(const CrossingWalk& walk, const StreetVehicle& vehicle) {
  const double room = walk.radius + kTouch;
  return walk.to > walk.from ? walk.from > vehicle.low - room : walk.from < vehicle.high + room;
}

/// Whether the body is where vehicles drive. One that has come by parked cars to the edge of a lane
/// is not yet.
bool is_committed(const StreetTraffic& traffic, const CrossingWalk& walk) {
  return std::ranges::any_of(traffic.vehicles, [&](const StreetVehicle& vehicle) {
    return vehicle.speed >= kStaticSpeed && is_in_the_way(walk, vehicle);
  });
}

bool can_stop(const StreetVehicle& vehicle, double distance, double reaction) {
  const double v = vehicle.speed;
  return distance > v * reaction + v * v / (2.0 * kComfort) + kAlong;
}

}  // namespace

GapView look_at_gap(std::span<const StreetVehicle> traffic, std::span<const VehicleState> vehicles,
                    const CrossingWalk& walk,
                    const std::function<bool(std::uint32_t vehicle)>& sees) {
  GapView view;
  for (const StreetVehicle& vehicle : traffic) {
    const auto [distance, rear] = ahead(walk, vehicle);
    if (rear < 0.0) continue;  // it has passed
    const Inside person = inside(walk, vehicle);
    if (person.leave < 0.0 || is_beyond(walk, vehicle)) continue;
    const bool on_line = distance <= 0.0;
    const double arrives = time_to_drive(vehicle, distance);
    if (!on_line && !std::isfinite(arrives)) continue;  // stands before the line
    if (sees && !sees(vehicle.vehicle)) continue;
    const double passed = time_to_drive(vehicle, rear) + kAfter;
    if (on_line && !std::isfinite(passed)) {
      view.barred = true;
      view.enough = false;
      continue;
    }
    const bool after = passed <= person.enter;
    if (!after && arrives < view.next) {
      view.next = arrives;
      view.vehicle = vehicles[vehicle.vehicle].key;
    }
    const bool before = arrives >= person.leave + walk.margin;
    const bool stops = walk.insists && can_stop(vehicle, distance, kReaction);
    if (!after && !before && !stops) view.enough = false;
  }
  return view;
}

Passage pass_vehicles(const StreetTraffic& traffic, const CrossingWalk& walk, double fastest,
                      const std::function<bool(std::uint32_t vehicle)>& sees) {
  Passage passage;
  const bool committed = is_committed(traffic, walk);
  const double margin = committed ? kOnTheWay : walk.margin;
  passage.committed = committed;
  for (const StreetVehicle& vehicle : traffic.vehicles) {
    const auto [distance, rear] = ahead(walk, vehicle);
    const Inside person = inside(walk, vehicle);
    if (rear < 0.0 || person.leave < 0.0) continue;
    const double arrives = distance <= 0.0 ? 0.0 : time_to_drive(vehicle, distance);
    if (!std::isfinite(arrives)) continue;
    const bool in_the_way = is_in_the_way(walk, vehicle);
    if (vehicle.speed < kStaticSpeed) {
      passage.standing = std::min(passage.standing, person.enter * walk.speed);
      continue;
    }
    if (!in_the_way && !sees(vehicle.vehicle)) continue;
    const double in_time = arrives - margin;
    if (person.leave <= in_time) continue;
    if (!in_the_way && walk.insists && can_stop(vehicle, distance, kPrepared)) continue;
    const double needed = in_time > 0.0 ? person.leave / in_time : fastest;
    if (in_the_way) {
      passage.hurry = std::max(passage.hurry, std::min(needed, fastest));
    } else if (committed && needed < fastest) {
      passage.hurry = std::max(passage.hurry, needed);
    } else if (time_to_drive(vehicle, rear) + kAfter > person.enter) {
      passage.room = std::min(passage.room, person.enter * walk.speed);
    }
  }
  return passage;
}

double critical_gap(const CrossingWalk& walk) {
  return std::abs(walk.to - walk.from) / walk.speed + walk.start_up + walk.margin;
}

double expected_wait(double flow, double needed) {
  if (flow <= 0.0) return 0.0;
  const double x = flow * needed;
  return std::min((std::expm1(x) - x) / flow, kLongestWait);
}

}  // namespace pedzone
