// A zone: the edges whose persons pedzone walks, and the space they walk in.
#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "geometry/way_finder.hpp"
#include "zone/crosswalks.hpp"
#include "zone/network.hpp"
#include "zone/streets.hpp"
#include "zone/zone_file.hpp"

namespace pedzone {

/// Length of one edge type, for `pedzone inspect`.
struct TypeLength {
  std::string type;
  double length = 0.0;  ///< [m]
  int edges = 0;
  std::string bring_in;  ///< candidates left out: the attribute that would bring them in
};

struct Zone {
  std::string id;
  Parameters parameters;
  std::string model;
  const Weather* weather = &weather_list().front();
  std::unordered_set<int> edges;  ///< Network::edges indices of normal edges
  /// Edges between which people pass inside the zone, smaller index first, and at which junctions
  /// (ids); none: all along. See linked().
  std::map<std::pair<int, int>, std::set<std::string>> links;
  std::vector<int> lanes;             ///< lanes whose area is in the zone, those inside junctions
                                      ///< (walking areas, crossings) included; ascending
  Region walkable;                    ///< [m] where people may be
  std::vector<Vec2> seats;            ///< [m] where people can sit down; none: anywhere
  std::vector<Region> shades;         ///< [m] polygons of type pedzone.shade, where the weather
                                      ///< makes people seek them
  Region obstacles;                   ///< [m] buildings and the like near it, for pictures
  WallIndex walls;                    ///< borders of walkable
  WallIndex sight_walls;              ///< of obstacles: nobody sees through them
  WayFinder ways;                     ///< shortest paths in walkable
  std::vector<Street> streets;        ///< that people cross between the junctions
  Region crossable;                   ///< [m] the parts of them where people may cross
  WallIndex street_walls;             ///< of who crosses one: borders of walkable and streets
  Crosswalks crosswalks;              ///< over carriageways, without a signal
  std::vector<std::string> warnings;  ///< one line each, naming what they are about
  std::vector<TypeLength> inside, left_out;
};

/// Whether people pass from one edge of the zone to the other inside it, at a junction that both
/// have. Not over a signalled crossing: that is SUMO's, so that the zone is left before it.
bool linked(const Zone& zone, int edge, int other);
/// The same at that junction: the two sides of a street have two in common.
bool linked(const Zone& zone, int edge, int other, const std::string& junction);

/// Body clearance that ways keep to walls [m].
constexpr double kWayClearance = 0.3;

/// Builds the zones of a network, one per spec (or the automatic one when `specs` is empty).
/// An edge belongs to the first zone that names it. Throws InputError for unknown edges, lanes
/// or polygons, a zone without any walkable edge, and a network without shared space.
std::vector<Zone> build_zones(const Network& network, const std::vector<ZoneSpec>& specs);

}  // namespace pedzone
