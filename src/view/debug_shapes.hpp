// Paths of waypoints and what people are about to do, as SUMO's polygons and POIs: sumo-gui loads
// them with the scenario (--additional-files).
#pragma once

#include <string>
#include <vector>

#include "crowd/crowd.hpp"

namespace pedzone {

/// A person that pedzone walks.
struct DebuggedPerson {
  std::string id;
  Insight insight;
};

/// An additional file. Types of its shapes, so that a viewer can tell them apart:
///   pedzone.debug.path       the walking way along a path's waypoints
///   pedzone.debug.waypoint   each waypoint (a POI), pedzone.debug.radius: its circle
///   pedzone.debug.aim        what a person heads for now (a POI), and a line to it
///   pedzone.debug.direction  the direction it chooses, as long as it gets in 2 s
///   pedzone.debug.rays       how far it finds each candidate direction free, out and back
/// `zones` are those in which the paths were found.
std::string debug_shapes(const std::vector<Zone>& zones, const std::vector<WaypointPath>& paths,
                         const std::vector<DebuggedPerson>& persons);

}  // namespace pedzone
