// `pedzone demand`: the people of a panel as a SUMO route file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/panel_options.hpp"

namespace pedzone {

struct DemandOptions {
  std::string config;     ///< .sumocfg
  std::string zone_file;  ///< empty: the zone is found by itself
  PanelOptions panel;
  std::optional<std::uint64_t> seed;
  std::string out;                        ///< route file to write
  std::vector<std::string> sumo_options;  ///< what stands after `--`
};

/// Writes; returns the exit code. Errors are printed, not thrown.
int demand(const DemandOptions& options);

}  // namespace pedzone
