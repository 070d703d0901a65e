// The files that `pedzone run` writes, beside SUMO's own.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "app/path_recorder.hpp"
#include "app/run.hpp"
#include "app/run_animation.hpp"
#include "conflict/tracker.hpp"
#include "results/complete_file.hpp"
#include "results/edge_data.hpp"
#include "results/trajectories.hpp"
#include "sumo/simulation.hpp"

namespace pedzone {

/// The files that were asked for, as the user named them.
std::vector<std::string> outputs_of(const RunOptions& options);

/// Throws InputError where two outputs, ours or SUMO's, name the same file, or two of ours standard
/// output.
void require_different_outputs(const RunOptions& options);

/// Where an output goes to standard output, nothing else does from now on: what SUMO and pedzone
/// tell goes to standard error. To be called in the process that runs.
void keep_standard_output_clean(RunOptions& options);

/// All finished together, or none.
class OutputFiles {
 public:
  /// Throws InputError where a file cannot be written, or two would be written to one file.
  explicit OutputFiles(const RunOptions& options);

  /// To be called before the first step.
  void begin(Simulation& simulation);
  /// After each step. `time` [s] before it, by which SUMO's own outputs name a step's result.
  void step(double time, Simulation& simulation);
  /// Throws std::runtime_error when the disk is full and the like.
  void finish(Simulation& simulation, const RunSummary& totals);

 private:
  void take_shapes(Simulation& simulation);
  void write_conflicts();
  void write_places(double time, Simulation& simulation);
  void write_edges(double time, Simulation& simulation);

  std::unique_ptr<CompleteFile> summary_;
  std::unique_ptr<TrajectoryWriter> trajectories_;
  bool everybody_ = false;  ///< trajectories of those, too, whom SUMO walks
  std::unique_ptr<CompleteFile> crossings_;
  std::unique_ptr<EdgeDataWriter> edge_data_;
  std::unique_ptr<CompleteFile> picture_;
  PathRecorder paths_;
  std::unique_ptr<RunAnimation> animation_;
  std::unique_ptr<CompleteFile> shapes_;
  double shapes_time_ = std::numeric_limits<double>::infinity();  ///< [s]
  std::string shapes_text_;  ///< empty: it is not yet that time
  std::unique_ptr<ConflictWriter> conflicts_;
  ConflictOptions conflict_options_;
  std::unique_ptr<ConflictTracker> tracker_;
  std::vector<Conflict> over_;
};

}  // namespace pedzone
