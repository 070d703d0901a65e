// What near walls hide from a point, by direction: most of a town lies behind them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/wall_index.hpp"

namespace pedzone {

class Outlook {
 public:
  /// Looks round from a point. To be called first, and again for each other point.
  void look(const WallIndex& walls, const Vec2& from);

  /// Hides all places in directions from `a` on counter-clockwise to `b`, less than half a turn,
  /// but for a hair beside these.
  void hide_between(const Vec2& a, const Vec2& b);

  /// Whether a wall lies between the point and the one at `offset` [m] from it, so that
  /// WallIndex::sees() says no. False says nothing.
  bool hides(const Vec2& offset) const {
    const double farthest = farthest_[sector_of(offset)];
    return offset.squaredNorm() > farthest * farthest;
  }

  /// Whether it hides all places in a box, as told by the offsets [m] of two of its corners. False
  /// says nothing.
  bool hides_box(const Vec2& low, const Vec2& high) const;

 private:
  static constexpr int kSectors = 512;  // numerical, by timing

  /// [0, 4] grows with the angle of a direction, and costs no more than a division.
  static double turn_of(const Vec2& d) {
    const double sum = std::abs(d.x()) + std::abs(d.y());
    const double share = sum > 0.0 ? d.y() / sum : 0.0;
    return d.x() < 0.0 ? 2.0 - share : (d.y() < 0.0 ? 4.0 + share : share);
  }
  static int sector_of(const Vec2& direction) {
    return std::min(static_cast<int>(turn_of(direction) * kSectors / 4.0), kSectors - 1);
  }
  /// Unit vectors along the borders at which the sectors begin.
  static const std::array<Vec2, kSectors>& borders();
  struct Borders {
    int first, last;
  };
  static Borders borders_between(const Vec2& a, const Vec2& b, double margin);
  void hide_behind(const Vec2& a, const Vec2& b);

  std::array<double, kSectors> farthest_;  ///< [m] what is farther away in the sector is hidden
  std::vector<std::uint64_t> seen_;        ///< of each wall, the last look that met it
  std::uint64_t looks_ = 0;
};

}  // namespace pedzone
