// Points on lanes. SUMO counts a lane's length apart from its shape's length; positions are
// scaled between the two, as SUMO does.
#pragma once

#include "zone/network.hpp"

namespace pedzone {

/// Length of a line [m].
double length_of(const Polyline& line);

/// A point on a line and the direction there.
struct LinePoint {
  Vec2 point;      ///< [m]
  Vec2 direction;  ///< unit vector along the line
};

/// The point at `offset` [m] along a line, clamped to its ends.
LinePoint point_on(const Polyline& line, double offset);

/// Where a point projects on a line.
struct LineProjection {
  double offset;   ///< [m] along the line, of the nearest point
  double lateral;  ///< [m] signed distance, positive to the left
};
LineProjection project_on(const Polyline& line, const Vec2& point);

/// The point at lane position `position` [m] (SUMO's count).
LinePoint point_on_lane(const Lane& lane, double position);

/// Lane position [m] (SUMO's count) and lateral offset of a point.
LineProjection project_on_lane(const Lane& lane, const Vec2& point);

}  // namespace pedzone
