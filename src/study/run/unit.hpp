// One run of a study: simulated, measured, recorded.
#pragma once

#include <string>

#include "study/run/file_sums.hpp"
#include "study/run/store.hpp"

namespace pedzone::study {

/// What is the same for all units of a driver.
struct RunContext {
  const Store& store;
  const Plan& plan;
  std::string pedzone;  ///< absolute path of the program
  FileSums sums;        ///< of inputs
};

/// Files in a run's folder while it is made.
inline constexpr const char* kLogFile = "log.txt";
inline constexpr const char* kFailureFile = "failure.txt";  ///< why it failed, in a sentence

/// The record of a run of which nothing is known but what goes into it. Throws InputError where
/// that cannot be read.
RunRecord blank_record(RunContext& context, const PlannedRun& run);

/// Makes a run in `folder`, which has been made for it, and puts it into its place. Writes whatever
/// anybody prints to the log there. To be called in a process of its own: returns the exit code. 0:
/// the run is in its place. Otherwise the folder is left; 128 + signal where somebody has killed a
/// program of the run.
int make_run(RunContext& context, const PlannedRun& run, int attempt, const std::string& folder);

}  // namespace pedzone::study
