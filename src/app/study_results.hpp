// What a study's runs come to: tables and report in its directory.
#pragma once

#include <string>

#include "study/run/store.hpp"

namespace pedzone {

/// Writes report.html, summary.csv, summary.json and runs.csv, each complete or not at all, and
/// prints where they are. Throws InputError.
void write_results(const study::Store& store, const study::Plan& plan,
                   const study::Records& records);

/// How many runs are in which state.
struct RunCounts {
  std::size_t done = 0, failed = 0, killed = 0, missing = 0;
};
RunCounts count_runs(const study::Records& records);

}  // namespace pedzone
