// Makes the runs of a study, several at a time, each in a process of its own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/run/unit.hpp"

namespace pedzone::study {

/// What a driver tells while it works.
struct DriverEvents {
  /// A run has failed or was killed, and is tried once more. `why`: a sentence.
  std::function<void(const PlannedRun&, const std::string& why)> again;
  /// A run is over, after `wall_s` [s] of its last try. `why` is empty where it is done.
  std::function<void(const PlannedRun&, RunStatus, const std::string& why, double wall_s)> over;
  /// Several times a second.
  std::function<void()> tick;
};

struct DriverResult {
  std::size_t done = 0, failed = 0, killed = 0;
  bool interrupted = false;  ///< by SIGINT, SIGTERM or SIGHUP; what was not over is not counted
};

/// Indexes of the runs that have to be made: without a record, or killed; the failed ones, too,
/// where that is wanted.
std::vector<std::size_t> missing_runs(const Records& records, bool retry_failed);

/// Makes these runs (indexes of Plan::runs), up to `jobs` > 0 at a time, in this order. One that
/// fails, or takes longer than Study::time_limit, is tried once more, and then recorded as failed
/// with the end of its log; one that was killed twice from outside, as killed. What lay in the
/// place of a run is thrown away. No process and no unfinished folder is left, whatever happens.
/// Throws InputError where the disk is full: nothing is held against the runs then.
DriverResult make_runs(RunContext& context, const std::vector<std::size_t>& runs, int jobs,
                       const DriverEvents& events);

}  // namespace pedzone::study
