// The walls that a person may meet, as lists for square tiles of ground: one look-up a person.
// Walls stand still, so this is built once for a zone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/wall_index.hpp"
#include "model/fixed_point.hpp"

namespace pedzone {

/// A wall as seen from anywhere: where it begins and how it runs.
struct WallFace {
  LatticePoint from;
  float dx, dy;     ///< unit vector along it
  float length;     ///< [m]
  bool begin, end;  ///< whether its first (last) point is its own: shared points count once
};

class WallTiles {
 public:
  /// Lists for each tile the walls within `reach` [m] of some point of it.
  void build(std::span<const Wall> walls, double reach, const LatticeOrigin& origin);

  std::span<const WallFace> walls() const { return walls_; }

  /// Indices of walls(): all within `reach` of the point, and some farther ones.
  std::span<const std::uint32_t> near(const LatticePoint& point) const;

 private:
  std::vector<WallFace> walls_;
  std::int64_t x_least_ = 0, y_least_ = 0;  ///< lattice
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> tile_start_, tile_walls_;
};

}  // namespace pedzone
