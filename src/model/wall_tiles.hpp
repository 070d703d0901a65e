// The walls that a person may meet. They stand still, so this is built once for a zone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/wall_index.hpp"
#include "model/tile_lists.hpp"

namespace pedzone {

/// A wall as seen from its walkable side, the left one. From behind nobody minds it: whoever got
/// outside can come back.
struct WallFace {
  LatticePoint from, middle, to;
  float dx, dy;              ///< unit vector along it
  float length;              ///< [m]
  float before_x, before_y;  ///< unit vector along the wall that ends where this one begins
  /// Its first point sticks out into the walkable area (a person can touch it before it touches a
  /// wall), seen from this wall or the one before.
  bool corner;
  bool begins, ends;  ///< its first (last) point belongs to no other wall
};

class WallTiles {
 public:
  /// Lists for each tile the walls within `reach` [m] of some point of it.
  void build(std::span<const Wall> walls, double reach, const LatticeOrigin& origin);

  const WallFace& operator[](std::uint32_t i) const { return faces_[i]; }

  /// Indices of all walls within reach of the point, and of some farther ones.
  std::span<const std::uint32_t> near(const LatticePoint& point) const { return tiles_.at(point); }

 private:
  std::vector<WallFace> faces_;
  TileLists tiles_;
};

}  // namespace pedzone
