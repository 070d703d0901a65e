// Regions of the plane and the operations on them. Boost.Geometry does the work inside
// polygon.cpp; no other file includes it.
#pragma once

#include <span>
#include <vector>

#include "core/vec.hpp"

namespace pedzone {

using Ring = std::vector<Vec2>;  ///< [m] closed without repeating the first point

/// A simple polygon: `outer` counter-clockwise, `holes` clockwise.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

/// Disjoint polygons. Every function below returns a valid Region whatever it is given.
using Region = std::vector<Polygon>;

/// A region from any ring, self-crossing and repeated points included (even-odd rule).
/// Empty where nothing larger than a sliver remains.
Region repair(const Ring& ring);

Region unite(std::span<const Region> regions);
Region unite(const Region& a, const Region& b);
Region subtract(const Region& a, const Region& b);
Region intersect(const Region& a, const Region& b);

/// A line widened to `width` [m] with flat ends and round joins; a lane's area.
Region widen(const Polyline& line, double width);

/// All points within `distance` [m] of the region (negative: shrinks it).
Region grow(const Region& region, double distance);

/// Surface [m²].
double area(const Region& region);

/// Whether a point is inside or on the border. Linear in the number of points.
bool contains(const Region& region, const Vec2& point);

}  // namespace pedzone
