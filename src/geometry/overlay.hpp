// Boolean operations on polygons, by Boost.Polygon on a grid of whole millimetres. Used by
// polygon.cpp and offset.cpp only.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "geometry/polygon.hpp"

namespace pedzone::overlay {

/// A point of the grid [mm].
struct GridPoint {
  std::int64_t x = 0, y = 0;
  auto operator<=>(const GridPoint&) const = default;
};
using GridRing = std::vector<GridPoint>;

/// The nearest point of the grid.
Vec2 on_grid(const Vec2& point);

/// What lies in at least one of the polygons added.
class Cover {
 public:
  /// An outer ring and holes, either way round.
  struct Part {
    std::vector<GridRing> rings;
    bool any = false;  ///< rings are taken as even-odd, holes as cut out
  };

  /// A ring that does not cross itself.
  void add_simple(const Ring& ring);
  /// A valid region.
  void add(const Region& region);
  /// Any region: rings may cross themselves, holes may overlap or lie outside. It takes long to find
  /// out in a town.
  void add_any(const Region& region);

  const std::vector<Part>& parts() const { return parts_; }

 private:
  void add(const Region& region, bool any);

  std::vector<Part> parts_;
};

enum class Operation { kUnite, kSubtract, kIntersect };

/// Without slivers. Polygons, holes and the corners of rings are in an order that does not depend
/// on the order in which anything was added.
Region combine(const Cover& a, Operation operation, const Cover& b);

}  // namespace pedzone::overlay
