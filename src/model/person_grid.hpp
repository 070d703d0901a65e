// Where everybody is, in a uniform grid that is built anew each step by a counting sort: persons
// of one cell stand next to each other in memory, as do the cells of one row.
#pragma once

#include <cstdint>
#include <vector>

#include "model/fixed_point.hpp"
#include "world/snapshot.hpp"

namespace pedzone {

class PersonGrid {
 public:
  /// Sorts the persons. No allocation once sizes have settled.
  void build(const Persons& persons, const LatticeOrigin& origin);

  /// Calls visit(first, last) for runs of slots that together hold everybody within `reach` [m]
  /// of a point (and others).
  template <class Visit>
  void runs(const LatticePoint& point, float reach, Visit&& visit) const;

  // By slot.
  const std::int32_t* x() const { return x_.data(); }  ///< lattice
  const std::int32_t* y() const { return y_.data(); }
  const float* vx() const { return vx_.data(); }  ///< [m/s]
  const float* vy() const { return vy_.data(); }
  const float* radius() const { return radius_.data(); }          ///< [m]
  const std::uint32_t* person() const { return person_.data(); }  ///< index in Persons
  std::size_t size() const { return person_.size(); }

 private:
  /// Column or row of a lattice coordinate, clamped to the grid.
  int column(std::int64_t x) const { return cell_of(x - x_least_, columns_); }
  int row(std::int64_t y) const { return cell_of(y - y_least_, rows_); }
  int cell_of(std::int64_t distance, int count) const;

  std::int32_t x_least_ = 0, y_least_ = 0;
  double cells_per_lattice_ = 1.0;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> cell_start_;
  std::vector<std::uint32_t> cell_;  ///< of each person, while sorting
  std::vector<LatticePoint> point_;
  std::vector<std::int32_t> x_, y_;
  std::vector<float> vx_, vy_, radius_;
  std::vector<std::uint32_t> person_;
};

template <class Visit>
void PersonGrid::runs(const LatticePoint& point, float reach, Visit&& visit) const {
  if (columns_ == 0) return;
  const auto span =
      static_cast<std::int64_t>(std::ceil(static_cast<double>(reach) * kLatticePerMetre));
  const int left = column(point.x - span), right = column(point.x + span);
  const int low = row(point.y - span), high = row(point.y + span);
  for (int r = low; r <= high; ++r) {
    const std::uint32_t* start = cell_start_.data() + static_cast<std::size_t>(r) * columns_;
    visit(start[left], start[right + 1]);
  }
}

}  // namespace pedzone
