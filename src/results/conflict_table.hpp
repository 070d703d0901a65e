// The table of conflicts.
#pragma once

#include <array>
#include <optional>

#include "conflict/conflict.hpp"
#include "results/table.hpp"

namespace pedzone {

/// A measure with its name in files.
struct ConflictMeasure {
  const char *name, *unit, *meaning;
  std::optional<Extreme> Conflict::*extreme;
};
inline constexpr ConflictMeasure kConflictMeasures[] = {
    {"minTTC", "s", "least time to contact", &Conflict::ttc},
    {"maxDRAC", "m/s²", "greatest deceleration to avoid contact", &Conflict::drac},
    {"PET", "s", "least post-encroachment time", &Conflict::pet},
    {"minClearance", "m", "least clearance of the bodies; negative: overlap", &Conflict::clearance},
    {"contact", "m/s", "relative speed at the first contact", &Conflict::contact}};

/// What a vehicle's driver, or what protects people, made of a conflict, with its name in files.
struct ConflictReaction {
  const char *name, *meaning;
  std::optional<Reaction> reaction;
};
/// For testing a protection system: TTC at first detection, at first braking, and at its least.
std::array<ConflictReaction, 3> reactions_of(const Conflict& conflict);

/// Who, when and how; nine columns for each measure; the reactions.
const Table<Conflict>& conflict_table();

}  // namespace pedzone
