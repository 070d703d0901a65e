#include "model/candidates.hpp"

#include <cmath>
#include <limits>

#include "core/vec.hpp"

namespace pedzone {
namespace {

constexpr double kDegree = kPi / 180.0;

std::size_t padded_to_group(std::size_t n) {
  return (n + kDirectionGroup - 1) / kDirectionGroup * kDirectionGroup;
}

}  // namespace

Candidates::Candidates(double field) : field_(field) {
  // Strictly between the field's border and 180°, on each side; then 180° itself.
  std::size_t side = 0;
  while (field + kRestStepDegrees * static_cast<double>(side + 1) < 180.0) ++side;
  rest_count_ = field < 180.0 ? 2 * side + 1 : 0;

  const std::size_t padded = main_padded() + padded_to_group(rest_count_);
  offset_.assign(padded, 0.0);
  cosine_.assign(padded, 0.0F);
  sine_.assign(padded, 0.0F);
  half_cosine_.assign(padded, 0.0F);
  half_sine_.assign(padded, 0.0F);
  excluded_.assign(padded, std::numeric_limits<float>::infinity());

  const auto middle = static_cast<std::ptrdiff_t>(kMainDirections / 2);
  for (std::size_t k = 0; k < kMainDirections; ++k) {
    const auto from_middle = static_cast<double>(static_cast<std::ptrdiff_t>(k) - middle);
    put(k, field * (from_middle / static_cast<double>(middle)) * kDegree);
  }
  for (std::size_t i = 0; i < side; ++i) {
    const double offset = (field + kRestStepDegrees * static_cast<double>(i + 1)) * kDegree;
    put(main_padded() + i, -offset);
    put(main_padded() + side + i, offset);
  }
  if (rest_count_ > 0) put(main_padded() + 2 * side, kPi);
}

void Candidates::put(std::size_t k, double offset) {
  offset_[k] = offset;
  excluded_[k] = 0.0F;
  cosine_[k] = static_cast<float>(std::cos(offset));
  sine_[k] = static_cast<float>(std::sin(offset));
  half_cosine_[k] = static_cast<float>(std::cos(offset / 2.0));
  half_sine_[k] = static_cast<float>(std::sin(offset / 2.0));
  // Straight back is its own mirror image; rounded π would give it a side.
  if (offset == kPi) sine_[k] = half_cosine_[k] = 0.0F;
}

}  // namespace pedzone
