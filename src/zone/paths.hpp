// The user's waypoints: <path> elements of a zone file, each an order of SUMO's POIs of type
// pedzone.waypoint, found in the zones.
#pragma once

#include <string>
#include <vector>

#include "core/vec.hpp"

namespace pugi {
class xml_node;
}

namespace pedzone {

class XmlFile;
struct Network;
struct Zone;

/// A place to come by on the way.
struct Waypoint {
  Vec2 at = Vec2::Zero();  ///< [m]
  double radius = 1.0;     ///< [m] (0, 20] ε: so near, it is reached
};

/// One <path>, as the zone file has it.
struct PathSpec {
  std::string id;
  std::vector<std::string> waypoints;  ///< ids of POIs in their order; never empty
  std::string file;                    ///< where it stands, for messages
  int line = 0;
};

/// A waypoint of a path, in one zone.
struct PathStop {
  std::string poi;  ///< id
  Waypoint waypoint;
};

/// One <path>, found in the zones.
struct WaypointPath {
  std::string id;
  std::vector<std::vector<PathStop>> stops;  ///< of each zone, those that lie in it, in order

  /// What a person comes by in the zone.
  std::vector<Waypoint> waypoints(std::size_t zone) const;
};

/// Reads one <path>; it may come by a POI several times, but not twice in a row. Throws InputError.
PathSpec read_path(const XmlFile& file, const pugi::xml_node& node);

/// Looks the paths' waypoints up in the network and the zones. A waypoint without a radius of its
/// own has that of the zone's parameters. Throws InputError for an unknown POI, one that lies in no
/// zone, and one that cannot be walked to inside its zone, from the zone's lanes or from any
/// other waypoint of the path there.
std::vector<WaypointPath> find_paths(const Network& network, const std::vector<Zone>& zones,
                                     const std::vector<PathSpec>& specs);

/// The path of that id; null: there is none.
const WaypointPath* find_path(const std::vector<WaypointPath>& paths, const std::string& id);

/// "a, b, c"; "none" where there is no path: for messages.
std::string path_ids(const std::vector<WaypointPath>& paths);

}  // namespace pedzone
