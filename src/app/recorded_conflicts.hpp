// Conflicts of a recorded run.
#pragma once

#include <optional>
#include <vector>

#include "app/recording_options.hpp"
#include "conflict/conflict.hpp"
#include "conflict/tracker.hpp"

namespace pedzone {

/// Says that steps of floating-car data are too long to measure conflicts by, where they are.
void warn_of_long_steps(const ConflictTracker& tracker);

/// Those that `pedzone conflicts` tells of the recording's floating-car data: of people whom
/// pedzone walked where its trajectories are given, else of everybody. Only with moving vehicles,
/// and none of those whom SUMO inserts upon somebody. Nothing: there is no such data.
std::optional<std::vector<Conflict>> recorded_conflicts(const RecordingOptions& options);

}  // namespace pedzone
