// The circle is cut into sectors. A wall that crosses a whole sector hides what is behind it there:
//
//              \      /
//        ───────\────/─────── wall
//                \  /  hidden above, from the farther of the two places where the wall meets the
//                 ·    sector's borders
#include "geometry/outlook.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pedzone {
namespace {

constexpr double kReach = 30.0;  // [m] numerical, by timing: walls farther away are not looked at
// numerical: what a wall hides must be on its other side by far more than the micrometre from which
// on sees() tells sides apart.
constexpr double kLeastDistance = 1e-3;  // [m] of the point from the wall's line
constexpr double kLeastSine = 0.02;      // of the angle between a sector's border and the wall
constexpr double kBehind = 0.01;         // [m]
constexpr double kAtEnds = 1e-6;         // of a sector, that its border may miss the wall's end
constexpr double kNowhere = std::numeric_limits<double>::infinity();  // [m]

}  // namespace

const std::array<Vec2, Outlook::kSectors>& Outlook::borders() {
  static const auto kBorders = [] {
    std::array<Vec2, kSectors> all;
    for (int sector = 0; sector < kSectors; ++sector) {
      const double turn = 4.0 * sector / kSectors, part = turn - std::floor(turn);
      const Vec2 in_first_quarter(1.0 - part, part), in_second = left_of(in_first_quarter);
      const int quarter = static_cast<int>(turn);
      const Vec2 border = quarter % 2 == 0 ? in_first_quarter : in_second;
      all[sector] = (quarter < 2 ? border : Vec2(-border)).normalized();
    }
    return all;
  }();
  return kBorders;
}

void Outlook::look(const WallIndex& walls, const Vec2& from) {
  farthest_.fill(kNowhere);
  walls.near(from, kReach, near_);
  for (const std::uint32_t index : near_) {
    const Wall& wall = walls.walls()[index];
    const Vec2 a = wall.a - from, b = wall.b - from;
    const bool counter_clockwise = cross(a, b) > 0.0;
    hide_behind(counter_clockwise ? a : b, counter_clockwise ? b : a);
  }
}

/// `b` is counter-clockwise of `a`, as seen from the point.
void Outlook::hide_behind(const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length = along.norm(), area = cross(a, b);
  if (!(area >= kLeastDistance * length)) return;  // in line with the point, or no wall
  const double first = turn_of(a) * kSectors / 4.0;
  double last = turn_of(b) * kSectors / 4.0;
  if (last < first) last += kSectors;
  const int begin = static_cast<int>(std::ceil(first + kAtEnds));
  const int end = static_cast<int>(std::floor(last - kAtEnds));
  double before = kNowhere;
  const auto& all = borders();
  for (int border = begin; border <= end; ++border) {
    const double sine = cross(all[border % kSectors], along);  // times the wall's length
    const double here = sine >= kLeastSine * length ? area / sine + kBehind / kLeastSine : kNowhere;
    if (border > begin) {
      double& farthest = farthest_[(border - 1) % kSectors];
      farthest = std::min(farthest, std::max(before, here));
    }
    before = here;
  }
}

}  // namespace pedzone
