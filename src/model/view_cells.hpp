// Which cells of a grid can hold somebody that a person sees, for any place inside its own cell
// and any heading of a narrow sector: worked out once, looked up for each person.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pedzone {

/// Cells [left, right] of the row `row` above the person's own (all relative to its own cell).
struct CellRun {
  int row, left, right;
};

class ViewCells {
 public:
  /// Headings are told apart in so many equal sectors. Numerical: halving it adds 3 % of cells.
  static constexpr std::size_t kSectors = 64;

  ViewCells() = default;
  /// `sight` [m], `half_field` [rad] half angle of view, cells of width × height [m].
  ViewCells(double sight, double half_field, double width, double height);

  /// Runs that hold everybody visible for a heading [rad] in [-pi, pi].
  std::span<const CellRun> runs(double heading) const {
    const std::size_t s = sector(heading);
    return {runs_.data() + start_[s], start_[s + 1] - start_[s]};
  }

  /// How far the runs reach, in cells.
  int columns() const { return columns_; }
  int rows() const { return rows_; }

 private:
  static std::size_t sector(double heading);

  int columns_ = 0, rows_ = 0;
  std::vector<std::size_t> start_;
  std::vector<CellRun> runs_;
};

}  // namespace pedzone
