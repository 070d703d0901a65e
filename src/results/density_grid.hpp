// Where people are: their time in cells of a grid.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/vec.hpp"
#include "results/run_tables.hpp"

namespace pedzone {

inline constexpr double kDensityCell = 2.0;  ///< [m]

class DensityGrid {
 public:
  /// Somebody is at `at` [m] for so many seconds.
  void add(const Vec2& at, double seconds);
  /// The cells in which anybody was, from south to north and west to east.
  std::vector<DensityRow> rows() const;
  /// The same as a table (run_tables.hpp).
  std::string csv() const;

 private:
  std::unordered_map<std::uint64_t, double> time_;  ///< [s] by row and column
};

}  // namespace pedzone
