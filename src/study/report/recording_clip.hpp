// A part of a recording.
#pragma once

#include "results/recording.hpp"
#include "zone/shapes.hpp"

namespace pedzone::study {

/// What is within the box: moments outside are left out, and whoever has none inside. The times
/// stay.
Recording clipped(Recording recording, const Box& box);

/// The part of a recording with one person and one vehicle, where they are in it.
Recording only(Recording recording, const std::string& person, const std::string& vehicle);

}  // namespace pedzone::study
