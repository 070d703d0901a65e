// What near walls hide from a point, by direction: most of a town lies behind them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/wall_index.hpp"

namespace pedzone {

class Outlook {
 public:
  /// Looks round from a point. To be called first, and again for each other point.
  void look(const WallIndex& walls, const Vec2& from);

  /// Whether a wall lies between the point and the one at `offset` [m] from it, so that
  /// WallIndex::sees() says no. False says nothing.
  bool hides(const Vec2& offset) const {
    const double farthest = farthest_[sector_of(offset)];
    return offset.squaredNorm() > farthest * farthest;
  }

 private:
  static constexpr int kSectors = 512;  // numerical, by timing

  static double turn_of(const Vec2& direction);
  static int sector_of(const Vec2& direction);
  static Vec2 border_of(int sector);
  void hide_behind(const Vec2& a, const Vec2& b);

  std::array<double, kSectors> farthest_;  ///< [m] what is farther away in the sector is hidden
  std::vector<std::uint32_t> near_;
};

}  // namespace pedzone
