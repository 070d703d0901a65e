// Boxes along the axes.
#pragma once

#include <Eigen/Geometry>

#include "geometry/polygon.hpp"

namespace pedzone {

using Box = Eigen::AlignedBox2d;  ///< [m]

Box box_of(const Polyline& points);
Box box_of(const Region& region);
Box grown(const Box& box, double distance);

}  // namespace pedzone
