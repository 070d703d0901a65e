// Distances between points and segments.
#pragma once

#include <algorithm>

#include "core/vec.hpp"

namespace pedzone {

/// The point of the segment a – b that is nearest to `point`.
inline Vec2 nearest_on(const Vec2& a, const Vec2& b, const Vec2& point) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  if (length2 == 0.0) return a;
  const double share = (point - a).dot(along) / length2;
  if (share <= 0.0) return a;
  return share >= 1.0 ? b : Vec2(a + share * along);
}

/// Distance [m] between the segments a – b and c – d; zero where they meet.
inline double segment_distance(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  if (c_side * d_side < 0.0 && a_side * b_side < 0.0) return 0.0;
  return std::sqrt(
      std::min({(nearest_on(a, b, c) - c).squaredNorm(), (nearest_on(a, b, d) - d).squaredNorm(),
                (nearest_on(c, d, a) - a).squaredNorm(), (nearest_on(c, d, b) - b).squaredNorm()}));
}

}  // namespace pedzone
