// Where a run took place.
#pragma once

#include <vector>

#include "zone/paths.hpp"
#include "zone/zone.hpp"

namespace pedzone {

struct Place {
  Network network;
  std::vector<Zone> zones;
  std::vector<WaypointPath> paths;
};

}  // namespace pedzone
