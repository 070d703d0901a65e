// Regions of the plane and the operations on them. All work on a grid of whole millimetres
// (overlay.hpp). Results do not depend on the order of the operands.
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

/// Disjoint polygons. Every function below returns a valid Region; only make_valid takes others.
using Region = std::vector<Polygon>;

/// A region from any ring, self-crossing and repeated points included (even-odd rule).
/// Empty where nothing larger than a sliver remains.
Region repair(const Ring& ring);
/// The same for each ring of polygons: holes are cut out of their own, polygons may overlap.
Region make_valid(const Region& polygons);

Region unite(std::span<const Region> regions);
Region unite(const Region& a, const Region& b);
Region subtract(const Region& a, const Region& b);
Region intersect(const Region& a, const Region& b);

/// A line widened to `width` [m] with flat ends and round joins; a lane's area.
Region widen(const Polyline& line, double width);

/// How grow rounds a corner: with chords of its arc, or with one outer point for each quarter turn
/// (few corners; up to 1.42 times the distance away, never nearer).
enum class Corners { kRound, kMitred };

/// All points within `distance` [m] of the region (negative: shrinks it).
Region grow(const Region& region, double distance, Corners corners = Corners::kRound);
/// What lies in `where` of a region shrunk by `distance` [m] > 0, with round corners. Takes as long
/// as `where` has border near it.
Region shrink_within(const Region& region, double distance, const Region& where);

/// Surface [m²].
double area(const Region& region);
/// [m²] positive where the ring runs counter-clockwise; less where it crosses itself.
double signed_area(const Ring& ring);

/// Whether a point is inside or on the border. Linear in the number of points.
bool contains(const Region& region, const Vec2& point);

}  // namespace pedzone
