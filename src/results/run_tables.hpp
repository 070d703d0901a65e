// What a run of a study leaves besides its trajectories and conflicts.
#pragma once

#include <optional>

#include "results/table.hpp"

namespace pedzone {

/// What is in the zones: means over a window of time.
struct SeriesRow {
  double time = 0.0;                            ///< [s] where the window begins
  std::optional<double> persons, person_speed;  ///< number; [m/s]
  std::optional<double> density;                ///< [1/m²] that people are in
  std::optional<double> vehicles, vehicle_speed;
};
const Table<SeriesRow>& series_table();

/// How long people were in a cell of a grid.
struct DensityRow {
  double x = 0.0, y = 0.0;      ///< [m] south-west corner
  double person_seconds = 0.0;  ///< [s] >= 0
};
const Table<DensityRow>& density_table();

}  // namespace pedzone
