// The velocity obstacle VO = {m/t : m in body M, 0 < t ≤ τ} is convex where M does not hold the
// origin. A convex set's signed distance at q is the largest n·q − h(n) over unit vectors n, h its
// support function. That of VO is h_M(n)/τ where h_M(n) ≤ 0 and infinite elsewhere:
//
//        \  leg     /        normals n are allowed from that of one leg to that of the other;
//         \   VO   /         the largest value is at an end of that arc, at the normal of a side
//          \,----'/          of M, or where n points from a corner of M/τ to q.
//           ` M/τ
//        origin
#include "model/velocity_obstacle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pedzone {
namespace {

/// [m] and [m/s] by which what is equal may differ by rounding. Numerical.
constexpr double kTolerance = 1e-9;

class Search {
 public:
  Search(const ConvexBody& body, const Vec2& velocity, double time, bool within)
      : body_(body), velocity_(velocity), time_(time), within_(within) {
    for (const Vec2& corner : body.corners) middle_ += corner;
  }

  void try_normal(const Vec2& n) {
    const double support = support_of(n);
    if (!within_ && support > kTolerance) return;
    const double depth = support / time_ - n.dot(velocity_);
    const bool right = cross(middle_, n) < 0.0;
    const double preferred = right ? kTolerance : -kTolerance;
    if (found_ && depth >= best_.depth + preferred) return;
    if (found_ && depth > best_.depth - kTolerance && !right) return;
    best_ = {n, depth};
    found_ = true;
  }

  void try_directions() {
    const std::size_t count = body_.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
      const Vec2& corner = body_.corners[k];
      try_along(velocity_ - corner / time_);
      if (!within_) try_legs(corner);
      if (count > 1) {
        const Vec2 side = left_of(body_.corners[(k + 1) % count] - corner);
        try_along(side);
        try_along(-side);
      }
    }
  }

  const WayOut& best() const { return best_; }

 private:
  double support_of(const Vec2& n) const {
    double most = n.dot(body_.corners.front());
    for (const Vec2& corner : body_.corners) most = std::max(most, n.dot(corner));
    return most + body_.radius;
  }

  void try_along(const Vec2& direction) {
    const double length = direction.norm();
    if (length > kTolerance) try_normal(direction / length);
  }

  /// Normals of the two tangents through the origin to the disc round a corner: n·corner = −radius.
  void try_legs(const Vec2& corner) {
    const double distance2 = corner.squaredNorm(), r = body_.radius;
    const double across = std::sqrt(std::max(distance2 - r * r, 0.0));
    try_normal((-r * corner - across * left_of(corner)) / distance2);
    try_normal((-r * corner + across * left_of(corner)) / distance2);
  }

  const ConvexBody& body_;
  const Vec2& velocity_;
  double time_;
  bool within_;  ///< the origin is in the body
  Vec2 middle_ = Vec2::Zero();
  WayOut best_{Vec2::Zero(), 0.0};
  bool found_ = false;
};

/// Whether the body holds the origin: no side of it, nor corner, has the origin outside.
bool holds_origin(const ConvexBody& body) {
  const double r2 = body.radius * body.radius;
  bool left = true, right = true;
  for (std::size_t k = 0; k < body.corners.size(); ++k) {
    const Vec2 &a = body.corners[k], &b = body.corners[(k + 1) % body.corners.size()];
    const Vec2 along = b - a;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp(-a.dot(along) / length2, 0.0, 1.0) : 0.0;
    if ((a + share * along).squaredNorm() < r2) return true;
    const double side = cross(along, -a);
    left = left && side > 0.0;
    right = right && side < 0.0;
  }
  return left || right;
}

}  // namespace

WayOut way_out(const ConvexBody& body, const Vec2& velocity, double time, double step) {
  const bool within = holds_origin(body);
  Search search(body, velocity, within ? step : time, within);
  search.try_directions();
  return search.best();
}

}  // namespace pedzone
