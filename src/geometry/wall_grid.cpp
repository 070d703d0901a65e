#include "geometry/wall_grid.hpp"

namespace pedzone {
namespace {

// numerical: about the reach of a look-up. Half of it doubles the lists of long walls; twice of it
// makes each look-up go through walls that are out of reach.
constexpr double kCellSize = 4.0;  // [m]
// numerical: bounds memory on wide, nearly empty scenes (4 bytes a cell).
constexpr double kMostCells = 4e6;

}  // namespace

WallGrid::WallGrid(std::span<const Wall> walls) : cell_size_(kCellSize) {
  if (walls.empty()) return;
  Vec2 low = walls[0].a, high = walls[0].a;
  for (const Wall& wall : walls) {
    low = low.cwiseMin(wall.a).cwiseMin(wall.b);
    high = high.cwiseMax(wall.a).cwiseMax(wall.b);
  }
  // A margin, so that no wall lies on the rim.
  const Vec2 margin = Vec2::Constant(0.5);
  origin_ = low - margin;
  const Vec2 size = high - low + 2.0 * margin;
  cell_size_ = std::max(cell_size_, std::sqrt(size.x() * size.y() / kMostCells));
  columns_ = static_cast<int>(std::floor(size.x() / cell_size_)) + 1;
  rows_ = static_cast<int>(std::floor(size.y() / cell_size_)) + 1;

  const std::size_t cells = static_cast<std::size_t>(columns_) * rows_;
  cell_start_.assign(cells + 1, 0);
  const auto for_cells = [&](const Wall& wall, auto&& use) {
    cells_along(wall.a, wall.b, 0.0, [&](int column, int row) {
      use(static_cast<std::size_t>(row) * columns_ + column);
      return true;
    });
  };
  for (const Wall& wall : walls) {
    for_cells(wall, [&](std::size_t cell) { ++cell_start_[cell + 1]; });
  }
  for (std::size_t i = 0; i < cells; ++i) cell_start_[i + 1] += cell_start_[i];
  cell_walls_.resize(cell_start_[cells]);
  std::vector<std::uint32_t> next(cell_start_.begin(), cell_start_.end() - 1);
  for (std::uint32_t i = 0; i < walls.size(); ++i) {
    for_cells(walls[i], [&](std::size_t cell) { cell_walls_[next[cell]++] = i; });
  }
}

}  // namespace pedzone
