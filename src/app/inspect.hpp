// `pedzone inspect`: what would be controlled in a scenario, without running it.
#pragma once

#include <string>
#include <vector>

namespace pedzone {

struct InspectOptions {
  std::string config;                     ///< .sumocfg
  std::string zone_file;                  ///< empty: the zone is found by itself
  std::string svg;                        ///< picture to write; empty: none
  std::vector<std::string> sumo_options;  ///< what stands after `--`
};

/// Prints numbers and warnings, draws; returns the exit code. Errors are printed, not thrown; the
/// picture is then not written.
int inspect(const InspectOptions& options);

}  // namespace pedzone
