#include "crowd/state/body_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pedzone {
namespace {

constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ULL;  // 2^64 / golden ratio: spreads rows
constexpr double kLargest = 1e9;  // numerical: cells beyond this share one, so that casts and
                                  // products of two hold

constexpr int kCoarse = 4;  // numerical: squares of 2^4 cells, some 20 m, more than most boxes
constexpr std::int64_t kMostSquares = 4;    // numerical: of a larger box nothing is told
constexpr std::uint64_t kBitsPerBody = 16;  // numerical: so that few hashes are shared

}  // namespace

std::int64_t BodyGrid::cell(double coordinate) const {
  return static_cast<std::int64_t>(
      std::floor(std::clamp(coordinate * inverse_cell_, -kLargest, kLargest)));
}

std::uint64_t BodyGrid::bucket_of(std::int64_t column, std::int64_t row) const {
  const std::uint64_t spread = static_cast<std::uint64_t>(row) * kGolden;
  return ((spread >> 32) + static_cast<std::uint64_t>(column)) & mask_;
}

std::uint64_t BodyGrid::coarse_bit(std::int64_t column, std::int64_t row) const {
  const std::uint64_t both =
      static_cast<std::uint64_t>(column) * kGolden + static_cast<std::uint64_t>(row);
  return (both * kGolden >> 32) & (64 * coarse_.size() - 1);
}

bool BodyGrid::maybe_anybody(const Vec2& low, const Vec2& high) const {
  const std::int64_t first_column = cell(low.x()) >> kCoarse, first_row = cell(low.y()) >> kCoarse;
  const std::int64_t last_column = cell(high.x()) >> kCoarse, last_row = cell(high.y()) >> kCoarse;
  if (last_column - first_column > kMostSquares || last_row - first_row > kMostSquares) return true;
  for (std::int64_t row = first_row; row <= last_row; ++row) {
    for (std::int64_t column = first_column; column <= last_column; ++column) {
      const std::uint64_t bit = coarse_bit(column, row);
      if ((coarse_[bit / 64] >> (bit % 64) & 1U) != 0) return true;
    }
  }
  return false;
}

void BodyGrid::build(std::span<const double> x, std::span<const double> y, double reach) {
  const std::size_t count = x.size();
  inverse_cell_ = 1.0 / reach;
  mask_ = std::bit_ceil(2 * count + 1) - 1;
  start_.assign(mask_ + 2, 0);
  bucket_.resize(count);
  entries_.resize(count);
  coarse_.assign(std::bit_ceil((count * kBitsPerBody + 63) / 64 + 1), 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t column = cell(x[i]), row = cell(y[i]);
    bucket_[i] = static_cast<std::uint32_t>(bucket_of(column, row));
    ++start_[bucket_[i] + 1];
    const std::uint64_t bit = coarse_bit(column >> kCoarse, row >> kCoarse);
    coarse_[bit / 64] |= std::uint64_t{1} << (bit % 64);
  }
  for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<std::int32_t>(cell(y[i]));
    entries_[start_[bucket_[i]]++] = {Vec2(x[i], y[i]), static_cast<std::uint32_t>(i), row};
  }
  // Filling has moved every start to its bucket's end, which is the next bucket's start.
  std::copy_backward(start_.begin(), start_.end() - 1, start_.end());
  start_[0] = 0;
}

}  // namespace pedzone
