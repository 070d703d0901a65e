// A rectangle anywhere in the plane: what a vehicle is to those who may touch it.
#pragma once

#include <optional>

#include "core/vec.hpp"

namespace pedzone {

/// A stretch of time, or of a way; empty where leave < enter.
struct Stretch {
  double enter, leave;
  bool empty() const { return leave < enter; }
};

/// Cuts a stretch to where x + w·t lies in [-half, half].
void cut_to_slab(double x, double w, double half, Stretch& stretch);

struct Rectangle {
  Vec2 centre = Vec2::Zero();  ///< [m]
  Vec2 axis = Vec2(1.0, 0.0);  ///< unit vector along the first of `half`
  Vec2 half = Vec2::Zero();    ///< [m] ≥ 0, half the length and half the width

  /// The point in the rectangle's frame: x along the axis, y to its left, origin at the centre.
  Vec2 into_frame(const Vec2& point) const {
    const Vec2 d = point - centre;
    return {d.dot(axis), d.dot(left_of(axis))};
  }
  /// The point of the plane that is at `local` in the rectangle's frame.
  Vec2 out_of_frame(const Vec2& local) const {
    return centre + local.x() * axis + local.y() * left_of(axis);
  }
  /// Distance [m] from a point of the frame to the rectangle; 0 inside.
  double local_distance(const Vec2& local) const {
    return (local.cwiseAbs() - half).cwiseMax(0.0).norm();
  }
  /// Distance [m] from the point to the rectangle; 0 inside.
  double distance(const Vec2& point) const { return local_distance(into_frame(point)); }
  /// The same, negative inside: how deep, to the nearest side.
  double signed_distance(const Vec2& point) const;
};

/// Signed distance [m] from a point of a rectangle's frame to it; `half` as in Rectangle.
double signed_distance(const Vec2& half, const Vec2& local);

/// First t in [0, last] at which a point that is at `at` + t·`velocity` in a rectangle's frame lies
/// within `radius` [m] of it: the rectangle grown by the radius, with round corners. Nothing where
/// it never does.
std::optional<double> first_within(const Vec2& half, const Vec2& at, const Vec2& velocity,
                                   double radius, double last);

/// Whether the line from a to b runs through the rectangle; one that only touches it does not.
bool runs_through(const Rectangle& rectangle, const Vec2& a, const Vec2& b);

}  // namespace pedzone
