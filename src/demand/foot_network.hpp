// Which edges persons can walk between, as SUMO walks them.
#pragma once

#include <vector>

#include "zone/network.hpp"

namespace pedzone {

/// The part of the network, as seen by persons, that each edge is in: between edges of one part
/// there is a way on foot. -1 for edges that nobody may walk on.
std::vector<int> foot_parts(const Network& network);

}  // namespace pedzone
