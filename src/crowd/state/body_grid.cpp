#include "crowd/state/body_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pedzone {
namespace {

constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ULL;  // 2^64 / golden ratio: spreads rows
constexpr double kLargest = 1e9;  // numerical: cells beyond this share one, so that casts and
                                  // products of two hold

}  // namespace

std::int64_t BodyGrid::cell(double coordinate) const {
  return static_cast<std::int64_t>(
      std::floor(std::clamp(coordinate * inverse_cell_, -kLargest, kLargest)));
}

std::uint64_t BodyGrid::bucket_of(std::int64_t column, std::int64_t row) const {
  const std::uint64_t spread = static_cast<std::uint64_t>(row) * kGolden;
  return ((spread >> 32) + static_cast<std::uint64_t>(column)) & mask_;
}

void BodyGrid::build(std::span<const double> x, std::span<const double> y, double reach) {
  const std::size_t count = x.size();
  inverse_cell_ = 1.0 / reach;
  mask_ = std::bit_ceil(2 * count + 1) - 1;
  start_.assign(mask_ + 2, 0);
  bucket_.resize(count);
  entries_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    bucket_[i] = static_cast<std::uint32_t>(bucket_of(cell(x[i]), cell(y[i])));
    ++start_[bucket_[i] + 1];
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
