// Which bodies may touch within one substep.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.hpp"

namespace pedzone {

/// Bodies as arrays of equal length.
struct BodyArrays {
  std::span<const double> x, y;    ///< [m] centre
  std::span<const double> radius;  ///< [m]
};

/// A hashed uniform grid, filled by one counting sort a substep. Its size follows the number of
/// bodies and not the size of the zone, so a few people in a large town cost little and a dense
/// square is still resolved. Rows are hashed and columns follow each other, so the cells of a row
/// that are searched lie side by side.
class BodyGrid {
 public:
  /// Sorts the bodies into cells of `reach` [m]: two bodies whose centres are nearer than that
  /// are in neighbouring cells. No allocation once sizes have settled.
  void build(const BodyArrays& bodies, double reach);

  /// Calls visit(index) for every body that may lie in the box (a superset), each once.
  template <class Visit>
  void visit_box(const Vec2& low, const Vec2& high, const Visit& visit) const {
    if (entries_.empty()) return;
    const std::int64_t first_column = cell(low.x()), last_column = cell(high.x());
    const auto columns = static_cast<std::uint64_t>(last_column - first_column) + 1;
    for (std::int64_t row = cell(low.y()), last_row = cell(high.y()); row <= last_row; ++row) {
      const std::uint64_t buckets = columns < mask_ + 1 ? columns : mask_ + 1;
      std::uint64_t bucket = bucket_of(first_column, row);
      for (std::uint64_t k = 0; k < buckets; ++k, bucket = (bucket + 1) & mask_) {
        for (std::uint32_t e = start_[bucket]; e < start_[bucket + 1]; ++e) {
          // Another row with the same hash; its own turn may come.
          if (entries_[e].row == static_cast<std::int32_t>(row)) visit(entries_[e].body);
        }
      }
    }
  }

 private:
  struct Entry {
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
