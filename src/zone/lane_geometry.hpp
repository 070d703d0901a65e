// Points on lanes. SUMO counts a lane's length apart from its shape's length; positions are
// scaled between the two, as SUMO does.
#pragma once

#include "geometry/polyline.hpp"
#include "zone/network.hpp"

namespace pedzone {

/// [m] of a lane's shape for each metre as SUMO counts; 1 where it counts none.
double shape_scale(const Lane& lane);

/// The point at lane position `position` [m] (SUMO's count).
LinePoint point_on_lane(const Lane& lane, double position);

/// Lane position [m] (SUMO's count) and lateral offset of a point.
LineProjection project_on_lane(const Lane& lane, const Vec2& point);

/// [m] from a point to the lane's centre line.
double distance_to_lane(const Lane& lane, const Vec2& point);

}  // namespace pedzone
