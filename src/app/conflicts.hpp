// `pedzone conflicts`: the conflicts in SUMO's floating-car data, whoever walked its persons.
#pragma once

#include <string>
#include <vector>

#include "app/conflict_options.hpp"

namespace pedzone {

struct ConflictsOptions {
  std::string fcd;                      ///< fcd-output
  std::string scenario;                 ///< .sumocfg whose files tell sizes; empty: none
  std::vector<std::string> types;       ///< more files that do
  std::vector<std::string> as_persons;  ///< vehicle types that count as persons
  ConflictOptions conflicts;
};

/// Measures and writes; returns the exit code. Errors are printed, not thrown.
int conflicts(const ConflictsOptions& options);

}  // namespace pedzone
