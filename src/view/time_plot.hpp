// Time-plots in the manner of Jan, Kleen and Berns (figures 6 to 8 and 11): where everybody is at
// moments evenly apart, coloured by time.
#pragma once

#include <optional>
#include <string>

#include "results/place.hpp"
#include "results/recording.hpp"
#include "zone/shapes.hpp"

namespace pedzone {

struct TimePlotOptions {
  std::string title;
  Box area;                       ///< [m] to show; empty: where the persons are
  std::optional<double> every;    ///< [s] > 0 between two moments; unset: a round step, for 8 to 20
  std::optional<double> at = {};  ///< [s] a snapshot of this moment, with the ways until then
  bool legend = true;             ///< below the map, with the colours of time
  bool narrow = false;            ///< it will be shown some 500 pixels wide: texts must be larger
};

/// The picture as an SVG file: persons as discs, vehicles as outlines in the colours of the
/// moments, their ways, and the place (may be null) in grey with its waypoints as stars.
std::string time_plot(const Recording& recording, const Place* place,
                      const TimePlotOptions& options);

}  // namespace pedzone
