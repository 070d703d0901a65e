// What `pedzone inspect` says about zones.
#pragma once

#include <string>
#include <vector>

#include "zone/zone.hpp"

namespace pedzone {

/// Numbers, edge types inside and left out with the attribute that would bring them in, and all
/// warnings, as lines of text.
std::string zone_report(const Network& network, const std::vector<Zone>& zones);

}  // namespace pedzone
