// Plane vectors. Frame: SUMO's network metres, x east, y north; angles in radians,
// counter-clockwise from +x. SUMO's own degrees (clockwise from north) exist only in src/sumo.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

namespace pedzone {

using Vec2 = Eigen::Vector2d;        ///< [m] or [m/s], network frame
using Polyline = std::vector<Vec2>;  ///< [m] at least two points when it is a line

constexpr double kPi = std::numbers::pi;

/// z of the cross product a × b; positive when b is to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

inline bool finite(const Vec2& v) { return std::isfinite(v.x()) && std::isfinite(v.y()); }

/// Unit vector of an angle [rad, ccw from +x].
inline Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Angle of a vector [rad] in (-pi, pi]; 0 for the zero vector.
inline double angle_of(const Vec2& v) { return std::atan2(v.y(), v.x()); }

/// The vector turned a quarter to the left.
inline Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

/// The same angle in [-pi, pi].
inline double wrap_angle(double angle) { return std::remainder(angle, 2.0 * kPi); }

}  // namespace pedzone
