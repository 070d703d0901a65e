// Where a run took place.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "zone/paths.hpp"
#include "zone/zone.hpp"

namespace pedzone {

struct Place {
  Network network;
  std::vector<Zone> zones;
  std::vector<WaypointPath> paths;
  std::unordered_map<std::string, std::string> street_names = {};  ///< by edge; pictures show them
};

}  // namespace pedzone
