#include "model/person_grid.hpp"

#include <algorithm>

namespace pedzone {
namespace {

/// [m] side of a cell. Numerical: smaller cells cost more rows, larger ones more persons that are
/// looked at in vain.
constexpr double kCellSize = 1.0;
/// At most so many cells a person (plus a few), so that memory follows the number of persons.
constexpr double kCellsPerPerson = 8.0;
constexpr double kCellsAtLeast = 1024.0;

}  // namespace

int PersonGrid::cell_of(std::int64_t distance, int count) const {
  const double cell = static_cast<double>(distance) * cells_per_lattice_;
  return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
}

void PersonGrid::build(const Persons& persons, const LatticeOrigin& origin) {
  const std::size_t n = persons.size();
  columns_ = rows_ = 0;
  for (auto* array : {&x_, &y_}) array->resize(n);
  for (auto* array : {&vx_, &vy_, &radius_}) array->resize(n);
  for (auto* array : {&person_, &cell_}) array->resize(n);
  point_.resize(n);
  if (n == 0) return;

  for (std::size_t i = 0; i < n; ++i) point_[i] = to_lattice(persons.x[i], persons.y[i], origin);
  std::int32_t x_most = x_least_ = point_[0].x, y_most = y_least_ = point_[0].y;
  for (const LatticePoint& p : point_) {
    x_least_ = std::min(x_least_, p.x);
    x_most = std::max(x_most, p.x);
    y_least_ = std::min(y_least_, p.y);
    y_most = std::max(y_most, p.y);
  }
  const double width = (static_cast<double>(x_most) - x_least_) / kLatticePerMetre;
  const double height = (static_cast<double>(y_most) - y_least_) / kLatticePerMetre;
  const double most_cells = kCellsPerPerson * static_cast<double>(n) + kCellsAtLeast;
  double size = std::max(kCellSize, std::sqrt(width * height / most_cells));
  size = std::max(size, std::max(width, height) / most_cells);
  cells_per_lattice_ = 1.0 / (size * kLatticePerMetre);
  columns_ = static_cast<int>(width / size) + 1;
  rows_ = static_cast<int>(height / size) + 1;

  // Counting sort: count, prefix sums (cell_start_[c + 1] is where cell c is filled next), place.
  cell_start_.assign(static_cast<std::size_t>(columns_) * rows_ + 2, 0);
  for (std::size_t i = 0; i < n; ++i) {
    cell_[i] = static_cast<std::uint32_t>(row(point_[i].y) * columns_ + column(point_[i].x));
    ++cell_start_[cell_[i] + 2];
  }
  for (std::size_t c = 2; c < cell_start_.size(); ++c) cell_start_[c] += cell_start_[c - 1];
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t slot = cell_start_[cell_[i] + 1]++;
    x_[slot] = point_[i].x;
    y_[slot] = point_[i].y;
    vx_[slot] = static_cast<float>(persons.vx[i]);
    vy_[slot] = static_cast<float>(persons.vy[i]);
    radius_[slot] = static_cast<float>(persons.radius[i]);
    person_[slot] = static_cast<std::uint32_t>(i);
  }
}

}  // namespace pedzone
