// Trajectories as CSV: one row per controlled person and step.
#pragma once

#include <string>
#include <string_view>

#include "crowd/crowd.hpp"
#include "output/complete_file.hpp"

namespace pedzone {

/// Columns: time [s], id, x, y [m, network frame], vx, vy [m/s], heading [rad, counter-clockwise
/// from +x], activity. Ids with commas, quotes or line ends are quoted as in RFC 4180.
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
