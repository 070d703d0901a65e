#include "geometry/rectangle.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone {
namespace {

constexpr double kParallel = 1e-9;  // [m] numerical: a way along the side neither enters nor leaves

}  // namespace

/// By the shares of the line that lie between each pair of opposite sides.
bool runs_through(const Rectangle& rectangle, const Vec2& a, const Vec2& b) {
  const Vec2 p = rectangle.into_frame(a), q = rectangle.into_frame(b);
  double enter = 0.0, leave = 1.0;
  for (int k = 0; k < 2; ++k) {
    const double way = q[k] - p[k], half = rectangle.half[k];
    if (std::abs(way) < kParallel) {
      if (std::abs(p[k]) > half) return false;
      continue;
    }
    const double first = (-half - p[k]) / way, second = (half - p[k]) / way;
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second));
  }
  return enter < leave;
}

}  // namespace pedzone
