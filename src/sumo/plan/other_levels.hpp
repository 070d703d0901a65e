// Bridges over a zone, and roads below one: their vehicles are nothing to its people.
#pragma once

#include <vector>

#include "zone/zone.hpp"

namespace pedzone {

/// Of each lane of the network, whether it overlaps lanes of the zones, and is on another level
/// than all of those where it does (levels.hpp). Where the file has no heights, none is.
std::vector<bool> lanes_on_other_levels(const Network& network, const std::vector<Zone>& zones);

}  // namespace pedzone
