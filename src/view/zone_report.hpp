// What `pedzone inspect` says about zones.
#pragma once

#include <string>
#include <vector>

#include "zone/zone.hpp"

namespace pedzone {

/// Of one zone.
struct ZoneFigures {
  double length = 0.0;   ///< [m] of its edges together
  double surface = 0.0;  ///< [m²] walkable
  long crossings = 0;
};
ZoneFigures figures_of(const Network& network, const Zone& zone);

/// What no zone has of the edges that persons may use.
std::vector<TypeLength> left_to_sumo(const Network& network, const std::vector<Zone>& zones);

/// Numbers, edge types inside and left out with the attribute that would bring them in, and all
/// warnings, as lines of text.
std::string zone_report(const Network& network, const std::vector<Zone>& zones);

}  // namespace pedzone
