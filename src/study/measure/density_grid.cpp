#include "study/measure/density_grid.hpp"

#include <cmath>
#include <map>

#include "results/run_tables.hpp"

namespace pedzone::study {
namespace {

/// Cells are told apart by halves of a number; biased, so that its order is theirs.
constexpr std::int64_t kBias = std::int64_t{1} << 31;

std::uint64_t half(double coordinate) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(coordinate / kCell)) +
                                    kBias);
}

double corner(std::uint64_t half) {
  return static_cast<double>(static_cast<std::int64_t>(half) - kBias) * kCell;
}

}  // namespace

void DensityGrid::step(double dt, std::span<const Walker> walkers) {
  for (const Walker& walker : walkers) {
    if (walker.zone == Walker::kNowhere || dt <= 0.0) continue;
    time_[half(walker.at.y()) << 32 | half(walker.at.x())] += dt;
  }
}

std::string DensityGrid::csv() const {
  std::string text = density_table().header();
  for (const auto& [cell, time] : std::map(time_.begin(), time_.end())) {
    density_table().append(text, {corner(cell & 0xffffffffU), corner(cell >> 32), time});
  }
  return text;
}

}  // namespace pedzone::study
