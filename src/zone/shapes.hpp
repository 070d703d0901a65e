// Areas, boxes and lines of a network's parts.
#pragma once

#include "geometry/box.hpp"
#include "zone/network.hpp"

namespace pedzone {

/// numerical: lanes narrower than this are widened to it, or no body has room on them [m].
constexpr double kLeastLaneWidth = 1.0;

/// A lane's area: its centre line widened; the outline of a walking area. Flat ends.
Region area_of(const Lane& lane);

/// Of the lane's area.
Box box_of(const Lane& lane);

/// Where the point of segment a–b nearest to `point` lies: 0 at a, 1 at b.
double nearest_part(const Vec2& a, const Vec2& b, const Vec2& point);

/// A point `inset` [m] inside a line from one of its ends; the middle of a line shorter than
/// twice that.
Vec2 inner_point(const Polyline& line, bool at_end, double inset);

}  // namespace pedzone
