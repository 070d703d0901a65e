// Zones where there can be some: a network without shared space is SUMO's alone.
#pragma once

#include <vector>

#include "zone/zone.hpp"

namespace pedzone {

/// Whether the rule of selection.hpp takes any edge.
bool has_shared_space(const Network& network);

/// As build_zones(), but no zone where none is named by a file and the rule takes no edge.
std::vector<Zone> build_any_zones(const Network& network, const std::vector<ZoneSpec>& specs);

}  // namespace pedzone
