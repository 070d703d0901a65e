// The measures of one run, from SUMO's outputs.
#pragma once

#include <map>
#include <string>

#include "view/place.hpp"

namespace pedzone {

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

/// Measures a run, and writes into its folder
///   conflicts.csv  as `pedzone conflicts --conflict-csv`
///   series.csv     time,persons,personSpeed,density,vehicles,vehicleSpeed: means over 10 s
///   density.csv    x,y,personSeconds: south-west corners of cells of 2 m in which anybody was [m]
/// Throws InputError where outputs are missing or cut off.
RunMeasures measure_run(const RunOutputs& outputs, const Place& place);

}  // namespace pedzone
