#include "zone/zone_distance.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone {
namespace {

constexpr double kCell = 8.0;  // [m] numerical: memory against how early somebody is noticed
// Numerical: cells of a larger area are larger, so that it costs no more memory (16 MB) or time.
constexpr double kMostCells = 4.0e6;
constexpr double kSamples = 4.0;  // numerical: points in a cell's length that mark cells on borders
constexpr double kMargin = 1.25;  // [cells] numerical: one and the corners between two samples

}  // namespace

ZoneDistance::ZoneDistance(const Zone& zone) {
  low_ = Vec2::Constant(1e18);
  high_ = Vec2::Constant(-1e18);
  for (const Polygon& polygon : zone.walkable) {
    for (const Vec2& point : polygon.outer) {
      low_ = low_.cwiseMin(point);
      high_ = high_.cwiseMax(point);
    }
  }
  const Vec2 size = high_ - low_;
  cell_ =
      std::max(kCell, std::sqrt(std::max(0.0, size.x()) * std::max(0.0, size.y()) / kMostCells));
  cell_ = std::max(cell_, size.maxCoeff() / kMostCells);
  columns_ = std::max(1, static_cast<int>(size.x() / cell_) + 1);
  rows_ = std::max(1, static_cast<int>(size.y() / cell_) + 1);
  constexpr int kUnknown = -1;
  steps_.assign(static_cast<std::size_t>(columns_) * rows_, kUnknown);

  std::vector<int> front;
  const auto mark = [&](int cell, int steps) {
    if (steps_[cell] != kUnknown) return;
    steps_[cell] = steps;
    front.push_back(cell);
  };
  for (const Wall& wall : zone.walls.walls()) {
    const int pieces = static_cast<int>((wall.b - wall.a).norm() * kSamples / cell_) + 1;
    for (int i = 0; i <= pieces; ++i) {
      const Vec2 point = wall.a + (wall.b - wall.a) * (static_cast<double>(i) / pieces);
      mark(row(point.y()) * columns_ + column(point.x()), 0);
    }
  }
  for (int cell = 0; cell < columns_ * rows_; ++cell) {
    const Vec2 centre = low_ + cell_ * Vec2(cell % columns_ + 0.5, cell / columns_ + 0.5);
    if (steps_[cell] == kUnknown && zone.walls.inside(centre)) mark(cell, 0);
  }
  for (std::size_t next = 0; next < front.size(); ++next) {
    const int x = front[next] % columns_, y = front[next] / columns_;
    for (int there_y = std::max(0, y - 1); there_y <= std::min(rows_ - 1, y + 1); ++there_y) {
      for (int there_x = std::max(0, x - 1); there_x <= std::min(columns_ - 1, x + 1); ++there_x) {
        mark(there_y * columns_ + there_x, steps_[front[next]] + 1);
      }
    }
  }
}

int ZoneDistance::column(double x) const {
  return static_cast<int>(std::clamp((x - low_.x()) / cell_, 0.0, columns_ - 1.0));
}

int ZoneDistance::row(double y) const {
  return static_cast<int>(std::clamp((y - low_.y()) / cell_, 0.0, rows_ - 1.0));
}

double ZoneDistance::at_least(const Vec2& point) const {
  const Vec2 nearest = point.cwiseMax(low_).cwiseMin(high_);
  const double outside = (point - nearest).norm();
  const int steps =
      steps_[static_cast<std::size_t>(row(nearest.y())) * columns_ + column(nearest.x())];
  // All of the area is inside the bounds, so the two ways meet at no less than a right angle.
  return std::hypot(outside, std::max(0.0, (steps - kMargin) * cell_));
}

}  // namespace pedzone
