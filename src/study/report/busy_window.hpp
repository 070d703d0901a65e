// The part of a run to show.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pedzone::study {

struct TimeWindow {
  double begin, end;  ///< [s]
};

/// Of several runs' series.csv (run_measures.hpp) the window in which most people are in the zones,
/// all runs together: 300 s, halved until no more than 60,000 person-seconds a run are in it, so
/// that a page can hold it. Unset where nobody ever is, or a file is missing or broken.
std::optional<TimeWindow> busiest_window(const std::vector<std::string>& series);

}  // namespace pedzone::study
