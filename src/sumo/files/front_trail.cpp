#include "sumo/files/front_trail.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"

namespace pedzone {
namespace {

constexpr double kSpacing = 1.0;   // [m] numerical: nearer places tell no direction
constexpr double kStraight = 2.0;  // [m] numerical: between places on the way that nobody has seen
constexpr int kBetween = 4;        // numerical: pieces of the way from one place to the next

/// Of three places in turn: the direction in which one is at the middle one.
Vec2 direction_at(const Vec2& before, const Vec2& here, const Vec2& after) {
  const Vec2 to = here - before, from = after - here;
  // That of the circle through them.
  return (to * (from.norm() / to.norm()) + from * (to.norm() / from.norm())).normalized();
}

/// Adds the way from a to b (b included) with these directions at its ends: a cubic curve.
void append_curve(const Vec2& a, const Vec2& b, const Vec2& at_a, const Vec2& at_b,
                  std::vector<Vec2>& out) {
  const double chord = (b - a).norm();
  for (int i = 1; i <= kBetween; ++i) {
    const double t = static_cast<double>(i) / kBetween, u = 1.0 - t;
    out.push_back(a * (u * u * (1.0 + 2.0 * t)) + b * (t * t * (3.0 - 2.0 * t)) +
                  (at_a * (u * u * t) - at_b * (t * t * u)) * chord);
  }
}

}  // namespace

void FrontTrail::begin(const Vec2& front, double heading, double length) {
  length_ = length;
  fronts_.clear();
  for (double behind = length; behind > 0.0; behind -= kStraight) {
    fronts_.push_back(front - unit(heading) * behind);
  }
  fronts_.push_back(front);
}

void FrontTrail::go_to(const Vec2& front) {
  const std::size_t last = fronts_.size() - 1;
  if ((fronts_[last] - fronts_[last - 1]).norm() < kSpacing) fronts_.pop_back();
  if ((front - fronts_.back()).norm() > 0.0) fronts_.push_back(front);
  // Two places more than it covers: directions need them.
  std::size_t needed = fronts_.size() - 1;
  for (double way = 0.0; needed > 0 && way < length_; --needed) {
    way += (fronts_[needed] - fronts_[needed - 1]).norm();
  }
  if (needed > 2) fronts_.erase(fronts_.begin(), fronts_.begin() + static_cast<long>(needed) - 2);
}

/// From the front on.
std::vector<Vec2> FrontTrail::backwards() const {
  const std::size_t n = fronts_.size();
  const std::vector<Vec2> places(fronts_.rbegin(), fronts_.rend());
  std::vector<Vec2> way{places.front()};
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Vec2 straight = (places[i + 1] - places[i]).normalized();
    const auto mirrored = [&](const Vec2& other) {  // as on a circle
      return Vec2(2.0 * straight.dot(other) * straight - other);
    };
    const bool first = i == 0, last = i + 2 == n;
    Vec2 here = straight, there = straight;
    if (!last) there = direction_at(places[i], places[i + 1], places[i + 2]);
    if (!first) here = direction_at(places[i - 1], places[i], places[i + 1]);
    if (first && !last) here = mirrored(there);
    if (last && !first) there = mirrored(here);
    append_curve(places[i], places[i + 1], here, there, way);
  }
  return way;
}

std::vector<Rectangle> FrontTrail::parts(const VehicleParts& parts, double width) const {
  const std::vector<Vec2> back = backwards();
  std::vector<Rectangle> found;
  for (int k = 0; k < parts.count(); ++k) {
    const VehiclePart part = part_of(parts, length_, k);
    const Vec2 front = point_on(back, length_ - part.rear - part.length).point;
    const Vec2 axis = (front - point_on(back, length_ - part.rear).point).normalized();
    found.push_back({front - axis * (0.5 * part.length), axis, {0.5 * part.length, 0.5 * width}});
  }
  return found;
}

}  // namespace pedzone
