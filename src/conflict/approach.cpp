#include "conflict/approach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/rectangle.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

Vec2 half_of(const Sizes& sizes) { return {sizes.half_length, sizes.half_width}; }

/// Distance of the origin from the line from a to b.
double distance_from_origin(const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double square = along.squaredNorm();
  const double share = square > 0.0 ? std::clamp(-a.dot(along) / square, 0.0, 1.0) : 0.0;
  return (a + share * along).norm();
}

/// Least signed distance of a way that leads into the rectangle. The nearest side changes where the
/// way crosses a middle line or a line through a corner at 45°; between these it is linear.
double deepest_on_way(const Vec2& half, const Vec2& from, const Vec2& way) {
  double least = 0.0;
  const auto look = [&](double rise, double to_go) {
    const double share = to_go / rise;
    if (share >= 0.0 && share <= 1.0) {
      least = std::min(least, signed_distance(half, from + share * way));
    }
  };
  look(way.x(), -from.x());
  look(way.y(), -from.y());
  for (const double side : {-1.0, 1.0}) {
    for (const double corner : {-1.0, 1.0}) {
      look(way.x() + side * way.y(), corner * (half.x() - half.y()) - (from.x() + side * from.y()));
    }
  }
  return least;
}

}  // namespace

double clearance(const Approach& a) {
  return signed_distance(half_of(a.sizes), a.at) - a.sizes.radius;
}

Closest closest_on_way(const Sizes& sizes, const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from, half = half_of(sizes);
  const auto touch = first_within(half, from, way, std::max(sizes.radius - kTouch, 0.0), 1.0);
  double least = std::min(signed_distance(half, from), signed_distance(half, to));
  if (first_within(half, from, way, 0.0, 1.0)) {
    least = std::min(least, deepest_on_way(half, from, way));
  } else {
    // Two shapes that do not meet are nearest at an end of the way or a corner of the rectangle.
    for (const double sx : {-1.0, 1.0}) {
      for (const double sy : {-1.0, 1.0}) {
        const Vec2 corner(sx * sizes.half_length, sy * sizes.half_width);
        least = std::min(least, distance_from_origin(from - corner, to - corner));
      }
    }
  }
  return {least - sizes.radius, touch};
}

std::optional<double> time_to_contact(const Approach& a) {
  const double room = clearance(a);
  if (room <= 0.0 && room > -kTouch) {
    const bool closing = a.velocity.dot(a.at - contact_point(a, 0.0)) < 0.0;
    return closing ? std::optional(0.0) : std::nullopt;
  }
  return first_within(half_of(a.sizes), a.at, a.velocity, a.sizes.radius, kForever);
}

Vec2 contact_point(const Approach& a, double ttc) {
  const Vec2 at = a.at + a.velocity * ttc;
  return {std::clamp(at.x(), -a.sizes.half_length, a.sizes.half_length),
          std::clamp(at.y(), -a.sizes.half_width, a.sizes.half_width)};
}

double closing_speed(const Approach& a, double time) {
  const Vec2 way = a.at + a.velocity * time - contact_point(a, time);
  const double length = way.norm();
  return length > 0.0 ? -a.velocity.dot(way) / length : a.velocity.norm();
}

//   The person is in the vehicle's way from t1 to t2. To be only at the person's place at t, it
//   needs f(t) = 2 (w t - gap)/t² with the speed w at which it closes in, or stands by then with
//   v/t. The smaller of both rises to one maximum and falls again; what is needed is its maximum
//   over [t1, t2].
std::optional<double> deceleration_to_avoid(const Approach& a) {
  const double side = a.speed < 0.0 ? -1.0 : 1.0;  // reversing: the rear leads
  const double v = side * a.speed, w = -side * a.velocity.x();
  const double gap = side * a.at.x() - a.sizes.half_length - a.sizes.radius;
  if (v < kHaltingSpeed || w <= 0.0 || gap <= 0.0 || !time_to_contact(a)) return std::nullopt;
  Stretch in_way{0.0, kForever};
  cut_to_slab(a.at.y(), a.velocity.y(), a.sizes.half_width + a.sizes.radius, in_way);
  const double t = std::clamp(2.0 * gap / std::max(w, 2.0 * w - v), in_way.enter, in_way.leave);
  return std::min(2.0 * (w * t - gap) / (t * t), v / t);
}

}  // namespace pedzone
