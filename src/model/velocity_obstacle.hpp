// The velocities at which a point runs into a convex body within a time, and the shortest way out
// of them (van den Berg et al. 2011, section 3 and Eq. 1 to 3, for any rounded convex body).
#pragma once

#include <span>

#include "core/vec.hpp"

namespace pedzone {

/// A convex body relative to the point: all within `radius` of a convex polygon (one corner: a
/// disc), its corners in order round it.
struct ConvexBody {
  std::span<const Vec2> corners;  ///< [m] 1 to kMostCorners
  double radius;                  ///< [m] > 0
};
inline constexpr std::size_t kMostCorners = 4;

/// The shortest change u of a relative velocity that takes it to the border of the velocity
/// obstacle: u = depth·normal.
struct WayOut {
  Vec2 normal;   ///< unit vector out of the obstacle
  double depth;  ///< [m/s] negative: the velocity is so far outside
};

/// The obstacle of velocities that hit the body within `time` [s]; of a body that the point is in
/// already, of those that still have it in there after `step` [s]. Of two ways out that are as
/// short the one to the right of the body wins.
WayOut way_out(const ConvexBody& body, const Vec2& velocity, double time, double step);

}  // namespace pedzone
