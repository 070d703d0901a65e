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
constexpr double kMargin = 0.01;         // of a sector, to what is not to be hidden
constexpr double kRounding = 1e-9;       // of a distance
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
  seen_.resize(walls.walls().size());
  ++looks_;
  walls.visit_near(from, kReach, [&](std::uint32_t index) {
    if (seen_[index] == looks_) return;
    seen_[index] = looks_;
    const Wall& wall = walls.walls()[index];
    const Vec2 a = wall.a - from, b = wall.b - from;
    const bool counter_clockwise = cross(a, b) > 0.0;
    hide_behind(counter_clockwise ? a : b, counter_clockwise ? b : a);
  });
}

/// A box that the point is not in takes up less than half of the circle.
bool Outlook::hides_box(const Vec2& low, const Vec2& high) const {
  const Vec2 nearest = low.cwiseMax(Vec2::Zero().cwiseMin(high));
  if (nearest.isZero()) return false;
  const int middle = sector_of(0.5 * (low + high));
  int first = 0, last = 0;
  for (const Vec2& corner : {low, high, Vec2(low.x(), high.y()), Vec2(high.x(), low.y())}) {
    const int turn = (sector_of(corner) - middle + 3 * kSectors / 2) % kSectors - kSectors / 2;
    first = std::min(first, turn);
    last = std::max(last, turn);
  }
  // Rounding may put a place in the box into the sector beside its corner's.
  const double distance = nearest.norm() * (1.0 - kRounding);
  for (int turn = first - 1; turn <= last + 1; ++turn) {
    if (distance <= farthest_[(middle + turn + kSectors) % kSectors]) return false;
  }
  return true;
}

/// The borders of sectors from `a` on to `b`, counter-clockwise, that are `margin` sectors or more
/// away from both; some count from 0 again.
Outlook::Borders Outlook::borders_between(const Vec2& a, const Vec2& b, double margin) {
  const double first = turn_of(a) * kSectors / 4.0;
  double last = turn_of(b) * kSectors / 4.0;
  if (last < first) last += kSectors;
  return {static_cast<int>(std::ceil(first + margin)), static_cast<int>(std::floor(last - margin))};
}

void Outlook::hide_between(const Vec2& a, const Vec2& b) {
  if (!(cross(a, b) > kLeastSine * a.norm() * b.norm())) return;  // hardly any, or more than half
  const Borders between = borders_between(a, b, kMargin);
  for (int border = between.first; border < between.last; ++border) {
    farthest_[border % kSectors] = 0.0;
  }
}

/// `b` is counter-clockwise of `a`, as seen from the point.
void Outlook::hide_behind(const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length = along.norm(), area = cross(a, b);
  if (!(area >= kLeastDistance * length)) return;  // in line with the point, or no wall
  const auto [begin, end] = borders_between(a, b, kAtEnds);
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
