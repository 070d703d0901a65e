// A person's way to its destination.
#pragma once

#include <limits>
#include <vector>

#include "crowd/state/person.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// Waypoints from where the person was when it planned to its destination.
struct Route {
  Destination destination;     ///< as given
  Vec2 aim_a = Vec2::Zero();   ///< [m] the part of the destination that the body has room
  Vec2 aim_b = Vec2::Zero();   ///< for: what it heads for, and where `last` lies
  std::vector<Vec2> points;    ///< [m] corners in turn, then a point of the aim; never empty
  std::size_t next = 0;        ///< the current waypoint
  Vec2 beside = Vec2::Zero();  ///< [m] from the current waypoint, a corner, to where it is passed
  Vec2 start = Vec2::Zero();   ///< [m] where it was planned from
  double beyond = 0.0;         ///< [m] way from the end on, where this is not the destination
  double rest = 0.0;           ///< [m] way from the current waypoint on, `beyond` included
  bool found = true;           ///< false: there is none, the person tries the straight line
  bool last_in_view = false;   ///< the nearest point of the aim can be headed for

  bool on_last() const { return next + 1 == points.size(); }
};

/// Plans the way from `from` to `destination` for a body of `radius` [m]: to the point of the
/// destination, shortened by the radius at both ends, that makes the way shortest. Where no way
/// exists (islands, bad data) the person heads straight for it. Keeps the capacity of
/// `route.points`.
void plan(const Zone& zone, const Vec2& from, double radius, const Destination& destination,
          Route& route);

/// Sets the current waypoint and the rest of the way.
void go_on_to(Route& route, std::size_t index);

/// The point [m] to head for from `position`: the current waypoint, or the nearest point of the
/// destination once that is in view.
Vec2 heading_point(const Route& route, const Vec2& position);

/// Way [m] that is left from `position` to the end.
double way_left(const Route& route, const Vec2& position);

/// Clearance [m] that a body of `radius` needs for a line to count as a way it can take: less
/// than the body itself, since it slides along a wall that it grazes, and no more than the
/// narrowest passage that ways lead through.
double passing_clearance(double radius);

}  // namespace pedzone
