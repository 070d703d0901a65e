#include "conflict/approach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// A stretch of time, or of a way; empty where leave < enter.
struct Stretch {
  double enter, leave;
  bool empty() const { return leave < enter; }
};

/// Cuts a stretch to where x + w·t lies in [-half, half].
void cut_to_slab(double x, double w, double half, Stretch& stretch) {
  if (w == 0.0) {
    if (std::abs(x) > half) stretch.leave = -kForever;
    return;
  }
  const double a = (-half - x) / w, b = (half - x) / w;
  stretch.enter = std::max(stretch.enter, std::min(a, b));
  stretch.leave = std::min(stretch.leave, std::max(a, b));
}

/// First t in [0, last] at which a point that is at `at` + t·`velocity` lies within `radius` of the
/// rectangle: the rectangle grown by the radius, with round corners.
std::optional<double> first_within(const Approach& a, const Vec2& at, const Vec2& velocity,
                                   double radius, double last) {
  Stretch inside{0.0, last};
  cut_to_slab(at.x(), velocity.x(), a.sizes.half_length + radius, inside);
  cut_to_slab(at.y(), velocity.y(), a.sizes.half_width + radius, inside);
  if (inside.empty()) return std::nullopt;
  const Vec2 entry = at + velocity * inside.enter;
  if (std::abs(entry.x()) <= a.sizes.half_length || std::abs(entry.y()) <= a.sizes.half_width) {
    return inside.enter;
  }
  // In the square about a round corner; whoever leaves it towards a side has met its circle.
  const Vec2 corner(std::copysign(a.sizes.half_length, entry.x()),
                    std::copysign(a.sizes.half_width, entry.y()));
  const Vec2 to = entry - corner;
  const double c = to.squaredNorm() - radius * radius;
  if (c <= 0.0) return inside.enter;
  const double b = to.dot(velocity), square = b * b - velocity.squaredNorm() * c;
  if (b >= 0.0 || square < 0.0) return std::nullopt;
  const double touch = inside.enter + c / (std::sqrt(square) - b);
  return touch <= inside.leave ? std::optional(touch) : std::nullopt;
}

double distance_to_rectangle(const Approach& a, const Vec2& at) {
  const double x = std::abs(at.x()) - a.sizes.half_length,
               y = std::abs(at.y()) - a.sizes.half_width;
  if (x <= 0.0 && y <= 0.0) return std::max(x, y);
  return Vec2(std::max(x, 0.0), std::max(y, 0.0)).norm();
}

/// Distance of the origin from the line from a to b.
double distance_from_origin(const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double square = along.squaredNorm();
  const double share = square > 0.0 ? std::clamp(-a.dot(along) / square, 0.0, 1.0) : 0.0;
  return (a + share * along).norm();
}

}  // namespace

double clearance(const Approach& a) { return distance_to_rectangle(a, a.at) - a.sizes.radius; }

Closest closest_on_way(const Approach& a, const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  const auto touch = first_within(a, from, way, std::max(a.sizes.radius - kTouch, 0.0), 1.0);
  double least = std::min(distance_to_rectangle(a, from), distance_to_rectangle(a, to));
  if (first_within(a, from, way, 0.0, 1.0)) {
    least = std::min(least, 0.0);
  } else {
    // Two shapes that do not meet are nearest at an end of the way or a corner of the rectangle.
    for (const double sx : {-1.0, 1.0}) {
      for (const double sy : {-1.0, 1.0}) {
        const Vec2 corner(sx * a.sizes.half_length, sy * a.sizes.half_width);
        least = std::min(least, distance_from_origin(from - corner, to - corner));
      }
    }
  }
  return {least - a.sizes.radius, touch};
}

std::optional<double> time_to_contact(const Approach& a) {
  const double room = clearance(a);
  if (room <= 0.0 && room > -kTouch) {
    const bool closing = a.velocity.dot(a.at - contact_point(a, 0.0)) < 0.0;
    return closing ? std::optional(0.0) : std::nullopt;
  }
  return first_within(a, a.at, a.velocity, a.sizes.radius, kForever);
}

Vec2 contact_point(const Approach& a, double ttc) {
  const Vec2 at = a.at + a.velocity * ttc;
  return {std::clamp(at.x(), -a.sizes.half_length, a.sizes.half_length),
          std::clamp(at.y(), -a.sizes.half_width, a.sizes.half_width)};
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
