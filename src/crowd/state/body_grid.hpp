// Which bodies may touch within one substep.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.hpp"

namespace pedzone {

/// A hashed uniform grid, filled by one counting sort a substep. Its size follows the number of
/// bodies and not the size of the zone, so a few people in a large town cost little and a dense
/// square is still resolved. Rows are hashed and columns follow each other, so the cells of a row
/// that are searched lie side by side.
class BodyGrid {
 public:
  /// Sorts the bodies into cells of `reach` [m]: two bodies whose centres are nearer than that
  /// are in neighbouring cells. No allocation once sizes have settled.
  void build(std::span<const double> x, std::span<const double> y, double reach);

  /// Calls visit(index, centre) for every body whose centre lies in the box, each once.
  template <class Visit>
  void visit_box(const Vec2& low, const Vec2& high, const Visit& visit) const {
    const auto inside = [&](const Entry& entry) -> bool {
      return (entry.centre.x() >= low.x()) & (entry.centre.x() <= high.x()) &
             (entry.centre.y() >= low.y()) & (entry.centre.y() <= high.y());
    };
    const std::int64_t first_column = cell(low.x()), first_row = cell(low.y());
    const std::int64_t columns = cell(high.x()) - first_column + 1;
    const std::int64_t rows = cell(high.y()) - first_row + 1;
    // More cells than bodies: looking at every body is less work.
    if (columns * rows > static_cast<std::int64_t>(entries_.size())) {
      for (const Entry& entry : entries_) {
        if (inside(entry)) visit(entry.body, entry.centre);
      }
      return;
    }
    for (std::int64_t row = first_row; row < first_row + rows; ++row) {
      std::uint64_t bucket = bucket_of(first_column, row);
      for (std::int64_t k = 0; k < columns; ++k, bucket = (bucket + 1) & mask_) {
        for (std::uint32_t e = start_[bucket]; e < start_[bucket + 1]; ++e) {
          // An entry of another row with the same hash has its turn, or not, with that row.
          if (entries_[e].row == row && inside(entries_[e])) {
            visit(entries_[e].body, entries_[e].centre);
          }
        }
      }
    }
  }

 private:
  /// Centres are kept in the order of the cells, since a search reads many and keeps few.
  struct Entry {
    Vec2 centre;  ///< [m]
    std::uint32_t body;
    std::int32_t row;
  };

  std::int64_t cell(double coordinate) const;
  std::uint64_t bucket_of(std::int64_t column, std::int64_t row) const;

  double inverse_cell_ = 1.0;         ///< [1/m]
  std::uint64_t mask_ = 0;            ///< buckets - 1, a power of two less one
  std::vector<std::uint32_t> start_;  ///< first entry of each bucket
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> bucket_;  ///< of each body
};

}  // namespace pedzone
