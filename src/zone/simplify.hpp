// Fewer corners: every corner of a walkable area is a wall for people and a node for their ways,
// every one of a line a part of a picture.
#pragma once

#include "geometry/polygon.hpp"

namespace pedzone {

/// The region without corners that lie within `tolerance` [m] of the border without them (Douglas
/// and Peucker 1973, ring by ring).
Region simplified(const Region& region, double tolerance);

/// The same of a line; its ends stay.
Polyline simplified(const Polyline& line, double tolerance);

}  // namespace pedzone
