// Names of streets with the lines to write them along.
#pragma once

#include <string>
#include <vector>

#include "results/place.hpp"
#include "zone/shapes.hpp"

namespace pedzone {

struct NamedStreet {
  std::string name;  ///< as in the network; a long one is cut
  Polyline line;     ///< [m]
};

/// Streets near `box` whose edges have a name. Edges of one name that go on at a junction are one
/// line, both directions of a street too. The same network gives the same order.
std::vector<NamedStreet> named_streets(const Place& place, const Box& box);

}  // namespace pedzone
