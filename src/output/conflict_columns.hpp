// The columns of the table of conflicts: what the writer writes and the reader expects.
#pragma once

#include <string>
#include <vector>

#include "conflict/conflict.hpp"

namespace pedzone {

/// A measure with its name in files.
struct ConflictMeasure {
  const char* name;
  std::optional<Extreme> Conflict::*extreme;
};
inline constexpr ConflictMeasure kConflictMeasures[] = {{"minTTC", &Conflict::ttc},
                                                        {"maxDRAC", &Conflict::drac},
                                                        {"PET", &Conflict::pet},
                                                        {"minClearance", &Conflict::clearance},
                                                        {"contact", &Conflict::contact}};

/// Names of all columns in their order: who, when and how; eight for each measure; the reactions.
std::vector<std::string> conflict_columns();

}  // namespace pedzone
