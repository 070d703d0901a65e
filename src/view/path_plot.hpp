// Everybody's way through the place, a line each.
#pragma once

#include <string>

#include "results/place.hpp"
#include "results/recording.hpp"
#include "zone/shapes.hpp"

namespace pedzone {

/// What the colour of a line tells. kAuto: the person where they are few, else the group where
/// these are, else nothing.
enum class PathColour { kAuto, kPerson, kGroup, kNone };

struct PathPlotOptions {
  std::string title;
  Box area;  ///< [m] to show; empty: where the persons are
  PathColour colour = PathColour::kAuto;
  bool narrow = false;  ///< it will be shown some 500 pixels wide: texts must be larger
};

/// The picture as an SVG file; the place may be null.
std::string path_plot(const Recording& recording, const Place* place,
                      const PathPlotOptions& options);

}  // namespace pedzone
