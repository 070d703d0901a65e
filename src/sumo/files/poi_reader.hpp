// The user's waypoints from an additional file: <poi type="pedzone.waypoint">.
#pragma once

#include "core/xml.hpp"
#include "sumo/files/geo_reader.hpp"
#include "zone/network.hpp"

namespace pedzone {

/// Adds them to the network, whose lanes have to be there: a POI stands at x, y or, as in SUMO, at
/// lane, pos (negative: from the lane's end) and posLat (to the left), or at lon, lat. Throws
/// InputError for an id that is taken, a place that cannot be used, and a radius out of (0, 20] m.
void read_waypoints(const XmlFile& additional_file, GeoPlaces& earth, Network& network);

}  // namespace pedzone
