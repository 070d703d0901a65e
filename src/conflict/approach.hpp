// A person and a vehicle at one moment, with their real shapes: how far apart, when they touch if
// both keep their velocity, and how hard the vehicle has to brake so that they do not.
#pragma once

#include <optional>

#include "core/vec.hpp"

namespace pedzone {

/// A person's disc and a vehicle's rectangle.
struct Sizes {
  double half_length = 2.5, half_width = 0.9;  ///< [m] > 0, of the vehicle
  double radius = 0.24;                        ///< [m] of the person
};

/// A person relative to a vehicle, in the vehicle's frame: x ahead of its centre, y to its left.
struct Approach {
  Vec2 at = Vec2::Zero();        ///< [m] centre of the person's disc
  Vec2 velocity = Vec2::Zero();  ///< [m/s] of the person, less the vehicle's
  double speed = 0.0;            ///< [m/s] of the vehicle along its axis; negative: reversing
  Sizes sizes;
};

/// `v` in the frame of a vehicle whose axis is `axis`.
inline Vec2 to_frame(const Vec2& axis, const Vec2& v) { return {axis.dot(v), cross(axis, v)}; }
inline Vec2 from_frame(const Vec2& axis, const Vec2& v) {
  return v.x() * axis + v.y() * left_of(axis);
}

/// [m] so deep an overlap is a contact: SUMO writes positions to 0.01 m, and bodies that were moved
/// apart touch exactly. Numerical.
inline constexpr double kTouch = 0.01;

/// Room [m] between the disc and the rectangle; negative: how deep they overlap, measured from the
/// disc's rim to the nearest side.
double clearance(const Approach& approach);

/// Least clearance while the person goes straight from `from` to `to`, both in the vehicle's frame,
/// and the share of that way [0, 1] at which they first touch (clearance < -kTouch).
struct Closest {
  double clearance;             ///< [m]
  std::optional<double> touch;  ///< share of the way
};
Closest closest_on_way(const Sizes& sizes, const Vec2& from, const Vec2& to);

/// TTC: time [s] ≥ 0 to the first touch if both keep their velocity and the vehicle its heading;
/// nothing where they never touch. 0 where they touch already, unless they only graze (by less than
/// kTouch) and do not close in.
std::optional<double> time_to_contact(const Approach& approach);

/// Where they touch at the time to contact `ttc`: the point of the rectangle next to the person's
/// centre, in the vehicle's frame.
Vec2 contact_point(const Approach& approach, double ttc);

/// Speed [m/s] at which the bodies come nearer after `time` [s] (negative: before now): the
/// relative velocity along the line from the nearest point of the rectangle to the person's centre.
/// Negative: they part. The whole relative speed where the centre lies within the rectangle.
double closing_speed(const Approach& approach, double time);

/// DRAC: the least constant deceleration [m/s²] > 0 along the vehicle's axis with which it does
/// not touch a person who keeps its velocity, or stands by the time they meet. Nothing where no
/// contact is ahead, or where braking does not help: it touches already, or the person walks into
/// its side. For one in front that walks the same way this is ½ Δv²/gap, and for one that crosses
/// 2 (v - gap/t)/t with the time t at which it leaves the vehicle's way, as SUMO 1.15's
/// MSDevice_SSM::computeDRAC (after Guido et al. 2011) has it; for one that comes towards the
/// vehicle, where SUMO computes none, v (v + 2u)/(2 gap) with its speed u. The front counts as a
/// line, so that a person at its corner has up to its radius less room than it really has.
std::optional<double> deceleration_to_avoid(const Approach& approach);

}  // namespace pedzone
