#include "crowd/sense/side_room.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "crowd/sense/vehicle_motion.hpp"
#include "geometry/polyline.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kPast = 0.1;    // [m] assumed: left between a body and a vehicle that passes it:
                                 // more than a creeping vehicle asks for (yield_plan.cpp)
constexpr double kTouch = 0.03;  // [m] numerical: a turned body keeps so much on either side
constexpr double kStraight = 0.25;      // [m] with so much room more, nobody need turn
constexpr double kSideStep = 0.05;      // [m] numerical: places that are tried beside the way
constexpr double kAlongStep = 0.5;      // [m] numerical: and along it
constexpr double kNearest = 0.5;        // [m] assumed: nor so near to the bumper
constexpr double kSwing = 0.05;         // [m] numerical: what counts as coming nearer
constexpr double kRing = 0.25;          // [m] numerical: steps that are tried
constexpr double kWider = 1.1;          // numerical: farther out, steps grow by so much
constexpr double kFarthestClear = 8.0;  // [m] assumed: out from between a car that turns round and
                                        // a wall, and past its length
constexpr double kTurnsBack = 1.5;      // assumed: so much farther a place seems behind one's back
constexpr int kDirections = 16;         // numerical
constexpr double kLook = 0.25;          // [m] numerical: sampling of the swept area
constexpr double kPassedBy = 1.0;       // [m] numerical: swept area beyond and behind the point

/// Whether it is farther than `reach` [m] from the point, told by its centre alone: a town has
/// hundreds of vehicles, a place a few.
bool is_far(const VehicleState& vehicle, const Vec2& point, double reach) {
  const double away = 0.5 * (vehicle.length + vehicle.width) + reach;
  return (vehicle.centre - point).squaredNorm() > away * away;
}

/// Whether somebody else is so near that a turned body has no room there.
bool is_taken(const SideRoom& room, const Vec2& to, double turned) {
  return std::ranges::any_of(room.others, [&](const OtherBody& other) {
    const double bodies = turned + other.radius;
    return (other.position - to).squaredNorm() < bodies * bodies;
  });
}

/// Whether a turned body at `to` has room between the walls, the other vehicles and people.
bool has_room(const SideRoom& room, const Vec2& to, double turned) {
  const double reach = turned + kTouch;
  if (!room.walls.inside(to) || room.walls.room(to, reach) < reach) return false;
  if (is_taken(room, to, turned)) return false;
  return std::ranges::none_of(room.vehicles,
                              [&](const Rectangle& other) { return other.distance(to) < reach; });
}

/// Whether a straight line runs through one of the rectangles.
bool leads_through_any(std::span<const Rectangle> others, const Vec2& from, const Vec2& to) {
  return std::ranges::any_of(others,
                             [&](const Rectangle& other) { return runs_through(other, from, to); });
}

/// Whether it fits there and gets there: other vehicles are as good as walls.
bool fits(const SideRoom& room, const Vec2& from, const Vec2& to, double turned) {
  return room.walls.sees(from, to) && has_room(room, to, turned) &&
         !leads_through_any(room.vehicles, from, to);
}

/// Whether somebody is on the straight way of a turned body.
bool is_barred(const SideRoom& room, const Vec2& from, const Vec2& to, double turned) {
  const Vec2 way = to - from;
  const double length = way.norm();
  if (length <= 0.0) return false;
  const Vec2 along = way / length;
  return std::ranges::any_of(room.others, [&](const OtherBody& other) {
    const Vec2 there = other.position - from;
    const double ahead = there.dot(along);
    return ahead > 0.0 && ahead < length && std::abs(cross(along, there)) < turned + other.radius;
  });
}

/// The other vehicles within `reach` [m] of a vehicle's centre, each grown by `grown` [m]. Valid
/// until the thread's next call: the list is kept for its memory.
std::span<const Rectangle> others_near(const SideRoom& room, const Vec2& centre, double reach,
                                       double grown) {
  thread_local std::vector<Rectangle> others;
  others.clear();
  for (const Rectangle& other : room.vehicles) {
    const double away = other.half.sum() + reach + grown;
    if ((other.centre - centre).squaredNorm() > away * away) continue;
    others.push_back(other);
    others.back().half += Vec2::Constant(grown);
  }
  return others;
}

/// Whether a straight line keeps so far from the walls, and out of the rectangles.
bool free_line(const WallIndex& walls, std::span<const Rectangle> others, const Vec2& from,
               const Vec2& to, double reach) {
  return walls.inside(from) && walls.free_line(from, to, reach) &&
         !leads_through_any(others, from, to);
}

/// The place beside the way at `offset` [m], on the one side, with most room up to `wanted`.
std::optional<Vec2> place_at(const SideRoom& room, const VehicleState& vehicle, const Vec2& from,
                             double offset, double side, const BodyBeside& body, double wanted) {
  const LinePoint at = point_on(vehicle.way, offset);
  const double least = body.radius + kPast;
  for (double beyond = std::max(wanted, least); beyond > least - 1e-9; beyond -= kSideStep) {
    const Vec2 place = at.point + left_of(at.direction) * side * (0.5 * vehicle.width + beyond);
    if (!fits(room, from, place, body.turned)) continue;
    if (runs_through(rectangle_of(vehicle), from, place)) continue;
    if (!comes_within(vehicle, place, least - 1e-9)) return place;
  }
  return std::nullopt;
}

/// Directions in which somebody at `from` may step away from the vehicle: straight away from it
/// first, and along its side and its way, where there may be room between it and a wall only.
std::array<Vec2, kDirections + 4> ways_out(const VehicleState& vehicle, const Vec2& from) {
  std::array<Vec2, kDirections + 4> directions;
  const double away = angle_of(from - vehicle.centre);
  for (int k = 0; k < kDirections; ++k) {
    const int turn = k % 2 == 0 ? k / 2 : -(k + 1) / 2;
    directions[static_cast<std::size_t>(k)] = unit(away + turn * 2.0 * kPi / kDirections);
  }
  const Vec2 side = unit(vehicle.heading);
  const Vec2 way = point_on(vehicle.way, project_on(vehicle.way, from).offset).direction;
  const std::array<Vec2, 4> along{side, Vec2(-side), way, Vec2(-way)};
  std::ranges::copy(along, directions.begin() + kDirections);
  return directions;
}

/// How far each part of its body gets at most for each metre that the vehicle drives on: front and
/// rear of the chord get no farther than that, the chord turns by at most twice that over its
/// length, and the body hangs over it.
double fastest_part(const VehicleState& vehicle, double cut) {
  const double chord = vehicle.length - 2.0 * cut;
  if (chord <= 0.0) return std::numeric_limits<double>::infinity();
  return 1.0 + 2.0 * (vehicle.length + 0.5 * vehicle.width) / chord;
}

}  // namespace

bool leads_through(const VehicleState& vehicle, const Vec2& from, const Vec2& to, double reach) {
  if (is_far(vehicle, from, (to - from).norm() + reach)) return false;
  Rectangle body = rectangle_of(vehicle);
  body.half += Vec2::Constant(std::min(reach, 0.5 * body.distance(from)));
  return runs_through(body, from, to);
}

bool may_be_passed(const VehicleState& vehicle) {
  return lets_squeeze_past(vehicle.velocity.norm()) && !vehicle.apart();
}

bool comes_within(const VehicleState& vehicle, const Vec2& point, double reach) {
  if (reach <= 0.0) return false;
  if (distance_to(vehicle, point) < reach) return true;
  if (vehicle.way.size() < 2) return false;
  const LineProjection at = project_on(vehicle.way, point);
  // Where the chord is short the rear hangs over behind it: farther than the chord cuts a corner.
  const double beyond = std::abs(at.lateral) - 0.5 * vehicle.width - reach;
  if (beyond > vehicle.length) return false;
  const double cut = most_cut(vehicle.way, vehicle.length), hangs_over = 2.0 * cut;
  if (beyond > hangs_over) return false;
  const double last = at.offset + kPassedBy + hangs_over;
  const double fastest = fastest_part(vehicle, cut);
  const double whole = length_of(vehicle.way) - vehicle.length;  // there its front is at the end
  BodyOnWay body(vehicle);
  double travelled = std::max(0.0, at.offset - vehicle.length - kPassedBy);
  while (travelled <= last) {
    const double distance = body.at(travelled).distance(point);
    if (distance < reach) return true;
    // What cannot be near yet is not looked at.
    double way = 0.0;
    do {
      travelled += kLook;
      way += kLook;
    } while (distance - fastest * way > reach && travelled + kLook < whole);
  }
  return false;
}

std::optional<Vec2> place_aside(const SideRoom& room, const VehicleState& vehicle, const Vec2& from,
                                const BodyBeside& body, double wanted) {
  if (vehicle.way.size() < 2) return std::nullopt;
  const LineProjection here = project_on(vehicle.way, from);
  const double own = here.lateral < 0.0 ? -1.0 : 1.0;
  for (double away = 0.0; away <= kStepsAside; away += kAlongStep) {
    for (const double offset : {here.offset + away, here.offset - away}) {
      if (offset < vehicle.length + kNearest && away > 0.0) continue;
      for (const double side : {own, -own}) {
        const auto place = place_at(room, vehicle, from, offset, side, body, wanted);
        if (place) return place;
      }
      if (away == 0.0) break;
    }
  }
  return std::nullopt;
}

bool swings_over(const VehicleState& vehicle, const Vec2& point, double radius) {
  const double now = distance_to(vehicle, point);
  return comes_within(vehicle, point, std::min(radius + kPast, now - kSwing));
}

bool holds_up(const VehicleState& vehicle, const Vec2& point, double radius) {
  if (vehicle.way.size() < 2) return false;
  return comes_within(vehicle, point, radius + kPast);
}

std::optional<Vec2> place_clear(const SideRoom& room, const VehicleState& vehicle, const Vec2& from,
                                const BodyBeside& body, double heading) {
  const Rectangle frame = rectangle_of(vehicle);
  const Vec2 onward = unit(heading);
  const auto directions = ways_out(vehicle, from);
  std::optional<Vec2> best;
  double least = std::numeric_limits<double>::infinity();  // [m] of its way, as it counts
  for (double step = kRing; step <= kFarthestClear && step < least;
       step = std::max(step + kRing, kWider * step)) {
    for (const Vec2& direction : directions) {
      const double way = direction.dot(onward) < 0.0 ? kTurnsBack * step : step;
      const Vec2 to = from + direction * step;
      if (way >= least || is_barred(room, from, to, body.turned)) continue;
      if (!fits(room, from, to, body.turned)) continue;
      if (runs_through(frame, from, to) || comes_within(vehicle, to, body.radius + kPast)) continue;
      best = to;
      least = way;
    }
  }
  return best;
}

std::optional<SideWay> way_beside(const SideRoom& room, const VehicleState& vehicle, double side,
                                  const BodyBeside& body) {
  const Rectangle frame = rectangle_of(vehicle);
  const double least = body.turned + kTouch, most = 2.0 * body.radius + kStraight;
  const auto others = others_near(room, frame.centre, frame.half.sum() + most, least);
  const auto free_at = [&](double beyond) {
    const double lateral = side * (frame.half.y() + beyond);
    const Vec2 ahead = frame.out_of_frame({frame.half.x(), lateral});
    const Vec2 behind = frame.out_of_frame({-frame.half.x(), lateral});
    return free_line(room.walls, others, ahead, behind, least);
  };
  double first = -1.0, last = -1.0;
  for (double beyond = least; beyond <= most; beyond += 0.2 * kSideStep) {
    if (free_at(beyond)) {
      if (first < 0.0) first = beyond;
      last = beyond;
    } else if (first >= 0.0) {
      break;
    }
  }
  if (first < 0.0) return std::nullopt;
  const bool narrow = last + body.turned + kTouch < most;
  return SideWay{side * (frame.half.y() + 0.5 * (first + last)), narrow};
}

}  // namespace pedzone
