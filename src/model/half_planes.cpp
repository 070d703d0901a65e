#include "model/half_planes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pedzone {
namespace {

/// [m/s] by which a half-plane may be missed, and below which two lines are parallel [1]: far above
/// rounding, far below any speed. Numerical: ten times less changes no velocity by more than that.
constexpr double kTolerance = 1e-9;

/// What is wanted of v: to be near to it, or far in its direction.
struct Aim {
  Vec2 wanted;
  bool direction;  ///< `wanted` is a direction
};

/// The best point of the border of `plane` within the disc and the other half-planes, if any.
std::optional<Vec2> on_border(const HalfPlane& plane, std::span<const HalfPlane> others,
                              double most, const Aim& aim) {
  const Vec2 foot = plane.least * plane.normal, along = left_of(plane.normal);
  const double square = most * most - plane.least * plane.least;
  if (square < -kTolerance) return std::nullopt;
  double last = std::sqrt(std::max(square, 0.0)), first = -last;
  for (const HalfPlane& other : others) {
    const double slope = other.normal.dot(along), missing = other.least - other.normal.dot(foot);
    if (std::abs(slope) <= kTolerance) {
      if (missing > kTolerance) return std::nullopt;
    } else if (slope > 0.0) {
      first = std::max(first, missing / slope);
    } else {
      last = std::min(last, missing / slope);
    }
  }
  if (first > last + kTolerance) return std::nullopt;
  const double place = along.dot(aim.direction ? aim.wanted : Vec2(aim.wanted - foot));
  const double t =
      aim.direction ? (place > 0.0 ? last : first) : std::clamp(place, std::min(first, last), last);
  return foot + t * along;
}

struct Outcome {
  Vec2 velocity;
  std::size_t kept;  ///< of the half-planes, from the first: all, or up to one that cannot be
};

/// Takes up one half-plane after the other: whichever the optimum so far violates has the next
/// optimum on its border.
Outcome optimum(std::span<const HalfPlane> planes, double most, const Aim& aim) {
  Vec2 best = aim.wanted;
  if (aim.direction || best.norm() > most) best *= most / std::max(best.norm(), kTolerance);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (planes[k].normal.dot(best) >= planes[k].least - kTolerance) continue;
    const std::optional<Vec2> found = on_border(planes[k], planes.first(k), most, aim);
    if (!found) return {best, k};
    best = *found;
  }
  return {best, planes.size()};
}

}  // namespace

Vec2 HalfPlaneProgram::solve(std::span<const HalfPlane> planes, std::size_t hard, double most,
                             const Vec2& wanted) {
  const Outcome first = optimum(planes, most, {wanted, false});
  Vec2 best = first.velocity;
  // Three dimensions, v and the shortfall d: least d with normal·v + d ≥ least for all soft ones.
  // Where plane k violates the optimum so far, it has the largest shortfall there, d = least_k −
  // normal_k·v; that others have no larger one is again a half-plane of v.
  double shortfall = 0.0;
  for (std::size_t k = first.kept; k < planes.size(); ++k) {
    const HalfPlane& plane = planes[k];
    if (plane.least - plane.normal.dot(best) <= shortfall + kTolerance) continue;
    work_.assign(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(hard));
    for (std::size_t j = hard; j < k; ++j) {
      const Vec2 difference = planes[j].normal - plane.normal;
      const double length = difference.norm();
      if (length <= kTolerance) continue;  // parallel: the one with the larger bound counts
      work_.push_back({difference / length, (planes[j].least - plane.least) / length});
    }
    const Outcome next = optimum(work_, most, {plane.normal, true});
    if (next.kept == work_.size())
      best = next.velocity;  // else rounding: the one before is as good
    shortfall = std::max(shortfall, plane.least - plane.normal.dot(best));
  }
  return best;
}

}  // namespace pedzone
