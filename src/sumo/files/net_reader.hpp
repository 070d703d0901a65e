// SUMO's network and polygon files as plain shapes. Reads XML only; needs no SUMO.
#pragma once

#include <string>

#include "zone/network.hpp"

namespace pedzone {

/// Reads a .net.xml or .net.xml.gz. Throws InputError naming file, line, element and value when
/// it is missing, malformed or not a network.
Network read_network(const std::string& net_file);

/// Adds the <poly> elements of an additional file (.xml or .xml.gz) and its waypoints (see
/// poi_reader.hpp) to the network. Longitudes and latitudes (geo="true") are led through the
/// network's projection. Polygons that have no place in it and those whose id is taken are left out
/// with a warning. Throws InputError as read_network.
void read_shapes(const std::string& additional_file, Network& network);

}  // namespace pedzone
