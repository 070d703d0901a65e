// The page of `pedzone run --animate`: the same as `pedzone animate` makes of the run's
// trajectories and SUMO's fcd-output. Both lie in a folder that is gone with the run.
#pragma once

#include <string>

#include "app/run_options.hpp"
#include "results/complete_file.hpp"
#include "results/trajectories.hpp"
#include "sumo/simulation.hpp"

namespace pedzone {

/// Has SUMO record everybody: in `folder`, or where the user says. Returns the file. Throws
/// InputError where the user says a place that cannot be read.
std::string record_everybody(Scenario& scenario, const std::string& folder);

class RunAnimation {
 public:
  /// Throws InputError where `options.animation` cannot be written.
  explicit RunAnimation(const RunOptions& options);

  /// After each step, as trajectories.
  void row(double time, const std::string& id, const PersonView& person) {
    trajectories_.row(time, id, person);
  }
  /// Reads what was recorded and writes the page. After SUMO has closed its outputs.
  void write(const Simulation& simulation);
  /// Moves the page to its place; where nobody was there, there is none.
  void finish();

 private:
  RunOptions options_;
  CompleteFile page_;
  TrajectoryWriter trajectories_;
  bool empty_ = false;
};

}  // namespace pedzone
