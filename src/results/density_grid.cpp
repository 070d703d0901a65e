#include "results/density_grid.hpp"

#include <cmath>
#include <map>

namespace pedzone {
namespace {

/// Cells are told apart by halves of a number; biased, so that its order is theirs.
constexpr std::int64_t kBias = std::int64_t{1} << 31;

std::uint64_t half(double coordinate) {
  return static_cast<std::uint64_t>(
      static_cast<std::int64_t>(std::floor(coordinate / kDensityCell)) + kBias);
}

double corner(std::uint64_t half) {
  return static_cast<double>(static_cast<std::int64_t>(half) - kBias) * kDensityCell;
}

}  // namespace

void DensityGrid::add(const Vec2& at, double seconds) {
  time_[half(at.y()) << 32 | half(at.x())] += seconds;
}

std::vector<DensityRow> DensityGrid::rows() const {
  std::vector<DensityRow> rows;
  for (const auto& [cell, time] : std::map(time_.begin(), time_.end())) {
    rows.push_back({corner(cell & 0xffffffffU), corner(cell >> 32), time});
  }
  return rows;
}

std::string DensityGrid::csv() const {
  std::string text = density_table().header();
  for (const DensityRow& row : rows()) density_table().append(text, row);
  return text;
}

}  // namespace pedzone
