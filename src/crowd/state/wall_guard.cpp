#include "crowd/state/wall_guard.hpp"

#include <algorithm>
#include <cmath>

#include "crowd/state/route.hpp"

namespace pedzone {
namespace {

// [m] numerical: how far walls are looked for. A walk of some seconds in the open between two
// look-ups; halving it doubles their number.
constexpr double kLook = 3.0;

}  // namespace

double wall_distance(const WallIndex& walls, const Vec2& point, double reach,
                     std::vector<std::uint32_t>& scratch) {
  walls.near(point, reach, scratch);
  double squared = reach * reach;
  for (const std::uint32_t w : scratch) {
    const Wall& wall = walls.walls()[w];
    squared = std::min(squared, (nearest_on_segment(point, wall.a, wall.b) - point).squaredNorm());
  }
  return std::sqrt(squared);
}

Vec2 kept_inside(const WallIndex& walls, const Vec2& from, const Vec2& to, double radius,
                 WallRoom& room, std::vector<std::uint32_t>& scratch) {
  const double needed = radius + (to - from).norm();
  if (room.distance >= needed) return to;
  if (!room.measured) {
    room = {wall_distance(walls, from, std::max(kLook, needed), scratch), true};
    if (room.distance >= needed) return to;
  }
  return walls.slide(from, to, radius);
}

}  // namespace pedzone
