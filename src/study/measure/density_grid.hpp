// Where people are: their time in cells of a grid over the zones.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>

#include "study/measure/walkers.hpp"

namespace pedzone::study {

inline constexpr double kCell = 2.0;  ///< [m]

class DensityGrid {
 public:
  /// Takes in a step, `dt` [s] after the one before.
  void step(double dt, std::span<const Walker> walkers);
  /// The table (results/run_tables.hpp) of the cells in which anybody was, from south to north and
  /// west to east.
  std::string csv() const;

 private:
  std::unordered_map<std::uint64_t, double> time_;  ///< [s] by row and column
};

}  // namespace pedzone::study
