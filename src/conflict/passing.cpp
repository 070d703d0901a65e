#include "conflict/passing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pedzone {
namespace {

/// [m] numerical: ways are summed up in single precision.
constexpr double kRounding = 0.01;

/// A moment of each way, as shares [0, 1] of the two pieces.
using Moments = Vec2;  // x: the person's, y: the vehicle's

/// A convex polygon of moments; a square cut by eight lines has at most twelve corners, and room is
/// for what rounding may add to them.
struct MomentArea {
  std::array<Moments, 16> corners;
  std::size_t size = 0;
  void add(const Moments& corner) {
    if (size < corners.size()) corners[size++] = corner;
  }

  /// What of it fulfils slope·m + offset ≤ 0.
  MomentArea cut(const Vec2& slope, double offset) const {
    MomentArea kept;
    for (std::size_t i = 0; i < size; ++i) {
      const Moments &a = corners[i], &b = corners[i + 1 < size ? i + 1 : 0];
      const double at_a = slope.dot(a) + offset, at_b = slope.dot(b) + offset;
      if (at_a <= 0.0) kept.add(a);
      if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0)) {
        kept.add(a + (b - a) * (at_a / (at_a - at_b)));
      }
    }
    return kept;
  }
};

/// The moments at which the shapes overlap: where the person is relative to the vehicle depends
/// linearly on them, and what is too near is convex.
MomentArea overlaps(const Vec2& at, const Vec2& by_person, const Vec2& by_vehicle,
                    const Sizes& sizes) {
  MomentArea area;
  area.add({0.0, 0.0});
  area.add({1.0, 0.0});
  area.add({1.0, 1.0});
  area.add({0.0, 1.0});
  const double radius = std::max(sizes.radius - kTouch, 0.0), diagonal = std::sqrt(0.5);
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      if (x == 0.0 && y == 0.0) continue;
      const Vec2 normal = x != 0.0 && y != 0.0 ? Vec2(x * diagonal, y * diagonal) : Vec2(x, y);
      const double reach = std::abs(normal.x()) * sizes.half_length +
                           std::abs(normal.y()) * sizes.half_width + radius;
      area = area.cut({normal.dot(by_person), -normal.dot(by_vehicle)}, normal.dot(at) - reach);
      if (area.size == 0) return area;
    }
  }
  return area;
}

bool same_way(const PersonPose& person, const VehiclePose& vehicle) {
  return std::abs(wrap_angle(static_cast<double>(person.direction - vehicle.direction))) < kSameWay;
}

Approach approach_of(const PersonPose& person, const VehiclePose& vehicle, const Sizes& sizes) {
  Approach approach;
  approach.at = to_frame(vehicle.axis, person.at - vehicle.centre);
  approach.sizes = sizes;
  return approach;
}

/// Visits the pieces k of `trail` in which the body can have met another one that is now at the end
/// of its newest piece, in which it moved by `moved` [m] since `since` [s]. `room(k)` [m]: its
/// clearance now from pose k. `visit(k)` looks closely and returns the least gap so far [s]: pieces
/// that lie longer ago need not be looked at.
template <typename Pose, typename Room, typename Visit>
void visit_near_pieces(const Trail<Pose>& trail, double moved, double since, double least,
                       const Room& room, const Visit& visit) {
  std::size_t k = 0;
  while (k + 1 < trail.size() && since - static_cast<double>(trail[k].time) < least) {
    const double needed = room(k) - moved - kRounding, here = trail[k].travelled;
    if (here - trail[trail.size() - 1].travelled < needed) return;
    const std::size_t looked = k;
    while (k + 1 < trail.size() && here - trail[k + 1].travelled < needed) ++k;
    if (k == looked) least = visit(k++);
  }
}

/// closest_in_time() where the vehicle turns so little that it keeps the mean of its two axes.
std::optional<Passing> closest_in_piece(const PersonPose& p0, const PersonPose& p1,
                                        const VehiclePose& v0, const VehiclePose& v1,
                                        const Sizes& sizes) {
  const Vec2 middle = v0.axis + v1.axis;
  const Vec2 axis = middle.norm() > 0.0 ? Vec2(middle.normalized()) : v1.axis;
  const MomentArea area = overlaps(to_frame(axis, p0.at - v0.centre), to_frame(axis, p1.at - p0.at),
                                   to_frame(axis, v1.centre - v0.centre), sizes);
  if (area.size == 0) return std::nullopt;
  const auto gap = [&](const Moments& m) {
    return p0.time + (p1.time - p0.time) * m.x() - v0.time - (v1.time - v0.time) * m.y();
  };
  Moments best = area.corners[0];
  double least = gap(best);
  for (std::size_t i = 1; i < area.size; ++i) {
    const double other = gap(area.corners[i]);
    if (other * least <= 0.0) least = 0.0;  // both at once in between
    if (std::abs(other) < std::abs(least)) {
      least = other;
      best = area.corners[i];
    }
  }
  return Passing{least, p0.at + (p1.at - p0.at) * best.x()};
}

/// Calls visit(from, to, number) for the pieces of the vehicle's way, of `all`.
template <typename Visit>
void visit_pieces(const VehiclePose& v0, const VehiclePose& v1, int all, const Visit& visit) {
  VehiclePose from = v0;
  for (int k = 0; k < all; ++k) {
    const VehiclePose to = k + 1 < all ? pose_between(v0, v1, (k + 1.0) / all) : v1;
    visit(from, to, k);
    from = to;
  }
}

}  // namespace

std::optional<Passing> closest_in_time(const PersonPose& p0, const PersonPose& p1,
                                       const VehiclePose& v0, const VehiclePose& v1,
                                       const Sizes& sizes) {
  std::optional<Passing> best;
  const double body = std::hypot(sizes.half_length, sizes.half_width);
  visit_pieces(v0, v1, pieces_that_keep_axis(v0, v1, body),
               [&](const VehiclePose& from, const VehiclePose& to, int /*number*/) {
                 const auto found = closest_in_piece(p0, p1, from, to, sizes);
                 if (found && (!best || found->pet() < best->pet())) best = found;
               });
  return best;
}

Closest closest_on_ways(const PersonPose& p0, const PersonPose& p1, const VehiclePose& v0,
                        const VehiclePose& v1, const Sizes& sizes) {
  Closest all{std::numeric_limits<double>::infinity(), std::nullopt};
  const int pieces = pieces_between(v0, v1);
  const auto person_at = [&](int piece) {
    return piece < pieces ? Vec2(p0.at + (p1.at - p0.at) * piece / pieces) : p1.at;
  };
  visit_pieces(v0, v1, pieces, [&](const VehiclePose& from, const VehiclePose& to, int number) {
    const Closest here = closest_on_way(sizes, to_frame(from.axis, person_at(number) - from.centre),
                                        to_frame(to.axis, person_at(number + 1) - to.centre));
    all.clearance = std::min(all.clearance, here.clearance);
    if (here.touch && !all.touch) all.touch = (number + *here.touch) / pieces;
  });
  return all;
}

std::optional<Passing> latest_passing(const Trail<PersonPose>& person,
                                      const Trail<VehiclePose>& vehicle, const Sizes& sizes,
                                      double below, const Order& order) {
  if (person.size() < 2 || vehicle.size() < 2) return std::nullopt;
  std::optional<Passing> best;
  double least = below;
  const auto look = [&](std::size_t i, std::size_t j) {
    if (same_way(person[i], vehicle[j])) return least;
    const auto found = closest_in_time(person[i + 1], person[i], vehicle[j + 1], vehicle[j], sizes);
    if (found && found->pet() < least) {
      best = found;
      least = found->pet();
    }
    return least;
  };
  if (order.vehicle_first) {
    visit_near_pieces(
        vehicle, static_cast<double>(person[0].travelled - person[1].travelled), person[1].time,
        least, [&](std::size_t k) { return clearance(approach_of(person[0], vehicle[k], sizes)); },
        [&](std::size_t k) { return look(0, k); });
  }
  if (order.person_first) {
    visit_near_pieces(
        person, vehicle[0].travelled - vehicle[1].travelled, vehicle[1].time, least,
        [&](std::size_t k) { return clearance(approach_of(person[k], vehicle[0], sizes)); },
        [&](std::size_t k) { return look(k, 0); });
  }
  return best;
}

}  // namespace pedzone
