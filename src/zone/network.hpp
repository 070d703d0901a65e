// A road network as plain shapes: what a zone is made of. Filled by src/sumo, known to nothing
// of SUMO itself.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "geometry/polygon.hpp"

namespace pedzone {

enum class EdgeFunction { kNormal, kInternal, kCrossing, kWalkingArea };

/// The classes of road vehicles that a lane lets in: a bit for each.
using RoadClasses = std::uint32_t;

inline constexpr int kRoadClassCount = 21;
inline constexpr RoadClasses kAllRoadClasses = (RoadClasses{1} << kRoadClassCount) - 1;
/// The bit of SUMO's vClass; 0: persons, rails, water, air, or a class that SUMO does not know.
RoadClasses road_class(std::string_view name);

struct Lane {
  std::string id;
  int edge = -1;          ///< index into Network::edges
  double speed = 0.0;     ///< [m/s] speed limit
  double width = 3.2;     ///< [m]
  double length = 0.0;    ///< [m] as SUMO counts it (may differ from the shape's length)
  bool persons = false;   ///< pedestrians may use it
  bool vehicles = false;  ///< some road vehicle or bicycle may use it
  RoadClasses road_classes = kAllRoadClasses;  ///< if so, which of them
  int opposite = -1;  ///< index into Network::lanes: the lane beside it for the other direction,
                      ///< on which vehicles may overtake; -1: none
  std::vector<int> yields_at;  ///< of one inside a junction: crossings (indices into
                               ///< Network::edges) before which its vehicles give way to people
  bool persons_only_by_default = false;  ///< persons may use it only since nothing forbids them:
                                         ///< no `allow` in the file names them
  Polyline shape;                        ///< [m] centre line; the outline for a walking area
  bool outline = false;                  ///< `shape` is an outline
  std::vector<double> z;  ///< [m] height of each shape point; empty when the file has none

  bool vehicles_only() const { return vehicles && !persons; }
  /// Whether a vehicle of that class (0: unknown) may use it.
  bool lets_in(RoadClasses its) const {
    return vehicles && (its == 0 || (road_classes & its) != 0);
  }
};

struct Edge {
  std::string id;
  std::string type;  ///< e.g. highway.pedestrian; empty when the file gives none
  EdgeFunction function = EdgeFunction::kNormal;
  std::string from, to;              ///< junction ids; empty for edges inside junctions
  std::vector<int> lanes;            ///< indices into Network::lanes, rightmost first
  std::vector<std::string> crossed;  ///< crossings: ids of the edges they lead over
  bool signalled = false;            ///< crossings: under a traffic light
  bool priority = false;             ///< crossings: all vehicles give way to people, without a
                                     ///< light; else those do of whom Lane::yields_at says so
  int line = 0;                      ///< in the network file, for messages
};

struct Connection {
  int from = -1, to = -1;  ///< lane indices
  int via = -1;            ///< lane inside the junction, -1 when there is none
};

struct Junction {
  std::string id, type;
  Ring shape;               ///< [m]
  bool street_end = false;  ///< one street with a carriageway ends here, and nothing else is:
                            ///< netconvert lays a walking area across its end, where vehicles
                            ///< appear and vanish
};

/// A polygon drawn by the user or imported from a map (SUMO's <poly>).
struct MapPolygon {
  std::string id, type;
  Ring shape;  ///< [m]
};

/// A place marked by the user (SUMO's <poi>) that people can be told to come by.
struct MapPoint {
  std::string id;
  Vec2 at = Vec2::Zero();        ///< [m]
  std::optional<double> radius;  ///< [m] (0, 20] parameter pedzone.radius
};

struct Network {
  std::string file;        ///< as the user named it
  bool left_hand = false;  ///< vehicles drive on the left
  std::vector<Edge> edges;
  std::vector<Lane> lanes;
  std::vector<Connection> connections;
  std::vector<Junction> junctions;
  std::vector<MapPolygon> polygons;
  std::vector<MapPoint> waypoints;  ///< points of type pedzone.waypoint
  std::vector<Vec2> seats;          ///< [m] points of type pedzone.seat
  std::unordered_map<std::string, int> edge_index, lane_index, junction_index;
  std::vector<std::string> warnings;  ///< what could not be used, one line each
};

/// The lane of an edge that SUMO's persons walk on: the first for pedestrians only, else the
/// first that allows them; -1 when none does.
int walking_lane(const Network& network, int edge);

/// Whether an edge has a lane for vehicles only.
bool has_carriageway(const Network& network, int edge);

/// Junction::street_end of that id; false for an id that no junction has.
bool is_street_end(const Network& network, const std::string& junction);

/// Whether a street crosses a railway there.
bool is_rail_crossing(const Network& network, const std::string& junction);

/// Edges shorter than this are never the place where persons are put or taken over: that makes
/// SUMO 1.15 abort in MSPModel_Striping::moveToNextLane (measured: 7 of 36 runs with them, 0 of 60
/// without).
constexpr double kShortEdge = 2.0;  // [m]

/// Whether the lane of an edge that persons walk on is so short, or there is none.
bool is_too_short(const Network& network, int edge);

}  // namespace pedzone
