// How crowded and how fast a run was, cell by cell.
#pragma once

#include <array>

#include "results/recording.hpp"
#include "view/grid_map.hpp"
#include "view/level_of_service.hpp"

namespace pedzone {

struct RunGrids {
  explicit RunGrids(double cell) : mean(cell, true), minute(cell, true), speed(cell, true) {}

  ValueGrid mean;    ///< [persons/m²] over the whole run
  ValueGrid minute;  ///< [persons/m²] over the peak minute: the one in which most people are there
  ValueGrid speed;   ///< [m/s] mean of those who are there, by time
  double begin = 0.0, end = 0.0;                ///< [s] of the run
  double minute_begin = 0.0, minute_end = 0.0;  ///< [s] of the peak minute
  double most = 0.0;               ///< [persons/m²] the highest mean of any cell and minute
  double most_begin = 0.0;         ///< [s] of its minute
  Vec2 most_at = Vec2::Zero();     ///< [m] its cell's middle
  double mean_where_people = 0.0;  ///< [persons/m²] over the run, of cells in which anybody was
  std::array<double, kServiceLevels.size()> area{};  ///< [m²] of cells at each level in `minute`
};

/// `cell` [m]: side of a cell. People outside `box` do not count. A run shorter than a minute is
/// one; where a rest is left after its last whole minute, the last 60 s are one, too.
RunGrids run_grids(const Recording& recording, const Box& box, double cell);

}  // namespace pedzone
