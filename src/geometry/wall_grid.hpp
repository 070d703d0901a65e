// A uniform grid over segments in compressed lists: which of them may be near a place or a line.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.hpp"

namespace pedzone {

/// A piece of border. The walkable side is to the left of a → b.
struct Wall {
  Vec2 a, b;  ///< [m]
};

class WallGrid {
 public:
  WallGrid() = default;
  explicit WallGrid(std::span<const Wall> walls);

  bool empty() const { return columns_ == 0; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double cell_size() const { return cell_size_; }

  /// Corners of the rectangle covered [m].
  const Vec2& low() const { return origin_; }
  Vec2 high() const { return origin_ + cell_size_ * Vec2(columns_, rows_); }

  /// Column and row of a coordinate, clamped to the grid.
  int column_of(double x) const { return clamped((x - origin_.x()) / cell_size_, columns_); }
  int row_of(double y) const { return clamped((y - origin_.y()) / cell_size_, rows_); }
  bool covers(const Vec2& point) const {
    return columns_ > 0 && (point.array() >= origin_.array()).all() &&
           (point.array() <= high().array()).all();
  }

  /// Indices of the walls that touch a cell, ascending.
  std::span<const std::uint32_t> cell(int column, int row) const {
    const std::size_t index = static_cast<std::size_t>(row) * columns_ + column;
    return std::span(cell_walls_)
        .subspan(cell_start_[index], cell_start_[index + 1] - cell_start_[index]);
  }

  /// Calls visit(wall index) for all walls in the cells that the rectangle touches, some of them
  /// more than once. Stops when visit returns false; says whether it went through.
  template <class Visit>
  bool visit_box(const Vec2& low, const Vec2& high, Visit visit) const {
    if (misses(low, high)) return true;
    const int last_column = column_of(high.x()), last_row = row_of(high.y());
    for (int row = row_of(low.y()); row <= last_row; ++row) {
      for (int column = column_of(low.x()); column <= last_column; ++column) {
        for (const std::uint32_t wall : cell(column, row)) {
          if (!visit(wall)) return false;
        }
      }
    }
    return true;
  }

  /// The same for the cells within `reach` [m] of the segment from → to.
  template <class Visit>
  bool visit_along(const Vec2& from, const Vec2& to, double reach, Visit visit) const {
    return cells_along(from, to, reach, [&](int column, int row) {
      for (const std::uint32_t wall : cell(column, row)) {
        if (!visit(wall)) return false;
      }
      return true;
    });
  }

 private:
  static int clamped(double value, int count) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(count - 1)));
  }

  /// Negated comparisons: a coordinate that is no number misses everything.
  bool misses(const Vec2& low, const Vec2& high) const {
    if (columns_ == 0) return true;
    const Vec2 top = this->high();
    return !(low.x() <= top.x() && low.y() <= top.y() && high.x() >= origin_.x() &&
             high.y() >= origin_.y());
  }

  /// Calls visit(column, row) for a superset of the cells within reach of a segment: row by row,
  /// the columns under the part of the segment that is within reach of the row.
  template <class Visit>
  bool cells_along(const Vec2& from, const Vec2& to, double reach, Visit visit) const {
    // A hair more, so that rounding never leaves out a cell.
    const double pad = reach + 1e-6;
    const Vec2 margin(pad, pad);
    if (misses(from.cwiseMin(to) - margin, from.cwiseMax(to) + margin)) return true;
    const Vec2 &lower = from.y() <= to.y() ? from : to, &upper = from.y() <= to.y() ? to : from;
    const Vec2 along = upper - lower;
    const int last_row = row_of(upper.y() + pad);
    for (int row = row_of(lower.y() - pad); row <= last_row; ++row) {
      const double bottom = origin_.y() + row * cell_size_ - pad - lower.y();
      const double top = bottom + cell_size_ + 2.0 * pad;
      // Rows at the rim also stand for what is beyond it.
      const double s = along.y() > 0.0 ? std::clamp(bottom / along.y(), 0.0, 1.0) : 0.0;
      const double t = along.y() > 0.0 ? std::clamp(top / along.y(), 0.0, 1.0) : 1.0;
      const double x = lower.x() + s * along.x(), x2 = lower.x() + t * along.x();
      const int last_column = column_of(std::max(x, x2) + pad);
      for (int column = column_of(std::min(x, x2) - pad); column <= last_column; ++column) {
        if (!visit(column, row)) return false;
      }
    }
    return true;
  }

  double cell_size_ = 4.0;      ///< [m]
  Vec2 origin_ = Vec2::Zero();  ///< [m] lower left corner
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> cell_start_, cell_walls_;
};

}  // namespace pedzone
