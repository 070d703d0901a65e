// The measures of one run, from SUMO's outputs.
#pragma once

#include <map>
#include <string>

#include "results/place.hpp"

namespace pedzone::study {

inline constexpr const char* kZoneConflicts = "zone-conflicts.csv";
inline constexpr const char* kCrossings = "crossings.csv";

/// Where a run's outputs lie, and what says how large everybody is.
struct RunOutputs {
  std::string folder;                     ///< holds fcd.xml.gz and tripinfo.xml
  std::string config;                     ///< .sumocfg
  std::vector<std::string> sumo_options;  ///< as given to SUMO: files in them count, too
  std::vector<std::string> types;         ///< more route files, e.g. of the panel's people
};

struct RunMeasures {
  std::map<std::string, double> values;       ///< by key of measure_list()
  std::map<std::string, std::string> demand;  ///< see RunRecord::demand
};

/// Measures a run in one pass over its floating-car data, whichever model wrote it, and writes into
/// its folder
///   conflicts.csv       as `pedzone conflicts --conflict-csv`
///   zone-conflicts.csv  those of them that count: of people in the zones (zone_stays.hpp)
///   series.csv          see run_series.hpp
///   density.csv         see results/density_grid.hpp
///   crossings.csv       as `pedzone conflicts --crossing-csv`, where streets may be crossed
///   anywhere
/// The same outputs give the same bytes. Throws InputError where outputs are missing, cut off, or
/// not of one run.
RunMeasures measure_run(const RunOutputs& outputs, const Place& place);

}  // namespace pedzone::study
