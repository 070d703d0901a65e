// Runs that are given up, and a disk that is full.
#pragma once

#include <string>

#include "core/child_process.hpp"
#include "study/run/unit.hpp"

namespace pedzone::study {

/// Why a run has failed, in a sentence: what it says itself in its folder, or how it ended.
std::string failure_sentence(const std::string& folder, const Ending& ending);

struct GivenUp {
  RunStatus status;
  std::string why;  ///< a sentence
  int attempts;
  double wall_s;  ///< [s]
};

/// Puts the folder of a run, with nothing but its log and a record that has the log's end, into the
/// run's place.
void record_failure(RunContext& context, const PlannedRun& run, const GivenUp& given_up,
                    const std::string& folder);

/// Throws InputError where a study's directory takes no more: no space left, and the like.
void check_disk(const std::string& results);

}  // namespace pedzone::study
