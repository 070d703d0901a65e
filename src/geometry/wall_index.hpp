// The walls of a walkable area (its borders), found fast.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygon.hpp"

namespace pedzone {

/// A piece of border. The walkable side is to the left of a → b.
struct Wall {
  Vec2 a, b;  ///< [m]
};

/// Borders of a region in a uniform grid. Immutable after construction; safe from many threads.
class WallIndex {
 public:
  WallIndex() = default;
  explicit WallIndex(const Region& walkable);
  /// For scenes that have walls but no area around them (tests, benchmarks): inside() is then
  /// true everywhere.
  explicit WallIndex(std::vector<Wall> walls);

  std::span<const Wall> walls() const { return walls_; }

  /// Indices of the walls that may be within `reach` [m] of `point`, ascending, each once,
  /// appended to `out` (cleared first). A superset: all that are within reach are there.
  void near(const Vec2& point, double reach, std::vector<std::uint32_t>& out) const;

  /// Whether the point is inside the region (border included).
  bool inside(const Vec2& point) const;

  /// Whether the segment from → to meets no wall within `clearance` [m] of it.
  bool free_line(const Vec2& from, const Vec2& to, double clearance = 0.0) const;

  /// The point nearest to `point` that is inside with `clearance` [m] to all walls where there is
  /// room for it (with what room there is elsewhere). Returns `point` itself when it qualifies.
  Vec2 nearest_inside(const Vec2& point, double clearance) const;

  /// Moves a disc of `radius` [m] from `from` (inside) towards `to`: stops or slides at walls,
  /// never ends outside, never passes through a wall. Returns where it ends.
  Vec2 slide(const Vec2& from, const Vec2& to, double radius) const;

 private:
  std::vector<Wall> walls_;
  bool bounded_ = false;        ///< built from a region: inside() means something
  double cell_size_ = 4.0;      ///< [m]
  Vec2 origin_ = Vec2::Zero();  ///< [m] lower left corner of the grid
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> cell_start_, cell_walls_;  ///< compressed lists, one per cell
};

}  // namespace pedzone
