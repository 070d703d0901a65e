// Where everybody is, in a uniform grid that is built anew each step by a counting sort: persons
// of one cell stand next to each other in memory, as do the cells of one row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/direction_kernel.hpp"
#include "model/fixed_point.hpp"
#include "model/tile_lists.hpp"
#include "model/view_cells.hpp"
#include "world/snapshot.hpp"

namespace pedzone {

class PersonGrid {
 public:
  /// Sorts the persons. `sight` [m] and `half_field` [rad] are what every person sees. No
  /// allocation once sizes have settled.
  void build(const Persons& persons, const LatticeOrigin& origin, double sight, double half_field);

  /// Groups of slots that together hold everybody whom a person at `point` (the place of one of
  /// `persons`) sees in `heading` [rad], and others. They stand in `space`.
  std::span<const SlotGroup> groups(const LatticePoint& point, double heading,
                                    std::vector<SlotGroup>& space) const;

  /// Of all persons; empty (right < left) without any.
  const LatticeBox& bounds() const { return bounds_; }

  PersonSlots slots() const {
    return {x_.data(),      y_.data(),       vx_.data(), vy_.data(), speed2_.data(), radius_.data(),
            turned_.data(), present_.data(), hx_.data(), hy_.data(), broadest_};
  }
  std::size_t size() const { return size_; }

 private:
  /// What every person sees.
  struct View {
    double sight = 0.0;       ///< [m]
    double half_field = 0.0;  ///< [rad]
    bool operator==(const View&) const = default;
  };
  /// The cells that people see for one size of cell. All that were used are kept: people come and
  /// go, and with them the widest view.
  struct Level {
    View view;
    double scale = 0.0;  ///< cells are this many times the smallest
    ViewCells cells;
  };
  struct Cell {
    int column, row;
  };

  const Level& level(const View& view, double scale);
  Cell cell_of(const LatticePoint& point) const;
  void choose_cells(const View& view, double scale);

  std::vector<Level> levels_;
  std::size_t level_ = 0;  ///< in use
  LatticeBox bounds_{0, 0, -1, -1};
  double columns_per_lattice_ = 1.0, rows_per_lattice_ = 1.0;
  int columns_ = 0, rows_ = 0;  ///< of the grid, its empty border included
  std::size_t size_ = 0;
  std::vector<std::uint32_t> cell_start_;  ///< slot at which each cell begins
  std::vector<std::uint32_t> cell_;        ///< of each person, while sorting
  std::vector<LatticePoint> point_;
  std::vector<std::int32_t> x_, y_;  ///< by slot, as the rest
  float broadest_ = 0.0F;            ///< [m] largest of the radii
  std::vector<float> vx_, vy_, speed2_, radius_, turned_, present_, hx_, hy_;
};

}  // namespace pedzone
