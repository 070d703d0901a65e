// Lists of things near each square tile of ground, so that a person finds what may concern it
// with one look-up.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "model/fixed_point.hpp"

namespace pedzone {

/// A box on the lattice, its borders included.
struct LatticeBox {
  std::int64_t left, low, right, high;
};

/// What is at most `reach` [lattice] from a point in each direction of the axes.
inline LatticeBox box_round(std::int64_t x, std::int64_t y, std::int64_t reach) {
  return {x - reach, y - reach, x + reach, y + reach};
}

/// The smallest box round the points (x[i], y[i]) [m]; where there are none it has no inside.
inline LatticeBox bounds_of(std::span<const double> x, std::span<const double> y,
                            const LatticeOrigin& origin) {
  constexpr auto kFarthest = std::numeric_limits<std::int64_t>::max();
  LatticeBox bounds{kFarthest, kFarthest, -kFarthest, -kFarthest};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const LatticePoint at = to_lattice(x[i], y[i], origin);
    bounds = {std::min<std::int64_t>(bounds.left, at.x), std::min<std::int64_t>(bounds.low, at.y),
              std::max<std::int64_t>(bounds.right, at.x),
              std::max<std::int64_t>(bounds.high, at.y)};
  }
  return bounds;
}

/// A tile size [lattice], `least` or twice as much as often as it takes, for which at most `most`
/// tiles cover the bounds: so memory follows what there is to list, not the size of the map.
inline std::int64_t tile_size_for(const LatticeBox& bounds, std::int64_t least, double most) {
  const auto width = static_cast<double>(bounds.right - bounds.left);
  const auto height = static_cast<double>(bounds.high - bounds.low);
  std::int64_t size = least;
  const auto tiles = [&] {
    return (width / static_cast<double>(size) + 1.0) * (height / static_cast<double>(size) + 1.0);
  };
  while (tiles() > most) size *= 2;
  return size;
}

class TileLists {
 public:
  /// Lists things 0 .. count − 1 for the tiles that cover `bounds`. `box(i)` is the LatticeBox in
  /// which thing i matters; `meets(i, tile)` may leave out tiles of it. No allocation once sizes
  /// have settled.
  template <class Box, class Meets>
  void build(const LatticeBox& bounds, std::int64_t tile_size, std::size_t count, Box&& box,
             Meets&& meets);

  /// Things that matter somewhere on the point's tile, ascending; none outside the bounds.
  std::span<const std::uint32_t> at(const LatticePoint& point) const {
    const std::int64_t x = point.x - bounds_.left, y = point.y - bounds_.low;
    if (x < 0 || y < 0 || point.x > bounds_.right || point.y > bounds_.high) return {};
    const auto tile = static_cast<std::size_t>(y / tile_size_ * columns_ + x / tile_size_);
    return {things_.data() + start_[tile], start_[tile + 1] - start_[tile]};
  }

 private:
  LatticeBox bounds_{0, 0, -1, -1};
  std::int64_t tile_size_ = 1, columns_ = 0;
  std::vector<std::uint32_t> start_, things_;
};

template <class Box, class Meets>
void TileLists::build(const LatticeBox& bounds, std::int64_t tile_size, std::size_t count,
                      Box&& box, Meets&& meets) {
  bounds_ = bounds;
  tile_size_ = tile_size;
  if (bounds.right < bounds.left || bounds.high < bounds.low) return;
  columns_ = (bounds.right - bounds.left) / tile_size + 1;
  const std::int64_t rows = (bounds.high - bounds.low) / tile_size + 1;

  const auto for_each_pair = [&](auto&& visit) {
    for (std::size_t i = 0; i < count; ++i) {
      const LatticeBox b = box(i);
      if (b.right < bounds.left || b.left > bounds.right) continue;
      if (b.high < bounds.low || b.low > bounds.high) continue;
      const std::int64_t c0 = std::max(b.left - bounds.left, std::int64_t{0}) / tile_size;
      const std::int64_t r0 = std::max(b.low - bounds.low, std::int64_t{0}) / tile_size;
      const std::int64_t c1 = std::min((b.right - bounds.left) / tile_size, columns_ - 1);
      const std::int64_t r1 = std::min((b.high - bounds.low) / tile_size, rows - 1);
      for (std::int64_t r = r0; r <= r1; ++r) {
        for (std::int64_t c = c0; c <= c1; ++c) {
          const std::int64_t x = bounds.left + c * tile_size, y = bounds.low + r * tile_size;
          if (meets(i, LatticeBox{x, y, x + tile_size, y + tile_size})) {
            visit(static_cast<std::size_t>(r * columns_ + c), static_cast<std::uint32_t>(i));
          }
        }
      }
    }
  };
  // Count, prefix sums (start_[t + 1] is where tile t is filled next), place.
  start_.assign(static_cast<std::size_t>(columns_ * rows) + 2, 0);
  for_each_pair([&](std::size_t tile, std::uint32_t) { ++start_[tile + 2]; });
  for (std::size_t t = 2; t < start_.size(); ++t) start_[t] += start_[t - 1];
  things_.resize(start_.back());
  for_each_pair(
      [&](std::size_t tile, std::uint32_t thing) { things_[start_[tile + 1]++] = thing; });
}

}  // namespace pedzone
