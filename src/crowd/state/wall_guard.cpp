#include "crowd/state/wall_guard.hpp"

#include <algorithm>

namespace pedzone {
namespace {

// [m] numerical: how far walls are looked for. A walk of some seconds in the open between two
// look-ups; halving it doubles their number.
constexpr double kLook = 3.0;

}  // namespace

Vec2 kept_inside(const WallIndex& walls, const Vec2& from, const Vec2& to, double radius,
                 WallRoom& room) {
  const double needed = radius + (to - from).norm();
  if (room.distance >= needed) return to;
  if (!room.measured) {
    room = {walls.room(from, std::max(kLook, needed)), true};
    if (room.distance >= needed) return to;
  }
  return walls.slide(from, to, radius);
}

}  // namespace pedzone
