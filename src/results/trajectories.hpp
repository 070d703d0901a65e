// Trajectories as CSV: one row per controlled person and step.
#pragma once

#include <string>
#include <string_view>

#include "crowd/crowd.hpp"
#include "results/complete_file.hpp"
#include "results/table.hpp"

namespace pedzone {

/// A person in one step.
struct TrajectoryRow {
  double time = 0.0;          ///< [s]
  std::string_view id;        ///< of the person; lives as long as what it was read from
  double x = 0.0, y = 0.0;    ///< [m] network frame
  double vx = 0.0, vy = 0.0;  ///< [m/s]
  double heading = 0.0;       ///< [rad] counter-clockwise from +x
  Motion motion = Motion::kWalking;
  Activity activity = Activity::kNone;
};

const Table<TrajectoryRow>& trajectory_table();

/// Writes the table.
class TrajectoryWriter {
 public:
  TrajectoryWriter(const std::string& path, const std::string& option);
  void row(double time, std::string_view id, const PersonView& person);
  void finish();

 private:
  void flush();
  CompleteFile file_;
  std::string buffer_;
};

}  // namespace pedzone
