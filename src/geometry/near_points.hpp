// Points by where they are, so that those near a place are found without a look at all.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.hpp"

namespace pedzone {

class NearPoints {
 public:
  NearPoints() = default;
  explicit NearPoints(std::span<const Vec2> points) { build(points); }

  /// Takes in the points [m], all finite, instead of those it had.
  void build(std::span<const Vec2> points);

  /// Which of them are at most `reach` [m] from `place` in each direction of the axes, ascending.
  std::vector<std::uint32_t> within(const Vec2& place, double reach) const;

 private:
  struct Entry {
    Vec2 point;
    std::uint32_t index;
  };
  std::vector<Entry> by_x_;
};

}  // namespace pedzone
