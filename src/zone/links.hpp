// How zone edges hang together at junctions: where SUMO's persons pass from one to the other.
#pragma once

#include <string>
#include <vector>

#include "zone/network.hpp"

namespace pedzone {

/// A junction passage between two zone edges.
struct Link {
  int from = -1, to = -1;  ///< Network edges, from < to
  std::string junction;    ///< id
  std::vector<int> way;    ///< lanes of walking areas and crossings passed, in order; empty
                           ///< at junctions without walking areas
};

/// All passages between edges of a zone (`edges`, ascending), one per pair and junction. At a
/// junction with walking areas: the shortest way over walking areas and crossings, none where it
/// leads over a signalled crossing or across the end of a street (that stays SUMO's). At one
/// without: between edges that connections join, or between all where the network has no walking
/// areas at all, as SUMO's persons pass between them at once. None over a level crossing.
std::vector<Link> find_links(const Network& network, const std::vector<int>& edges);

/// Lanes inside junctions that belong to a zone with these lanes (ascending): walking areas that
/// touch two edges of the zone, walking areas and crossings of its links, and the ways of vehicles
/// between its lanes. Ascending.
std::vector<int> inner_lanes(const Network& network, const std::vector<int>& lanes,
                             const std::vector<Link>& links);

/// Junctions whose whole area is shared: at least two edges of the zone meet there, no road that
/// stays SUMO's does, none with a carriageway beside its footways, and no signalled or level
/// crossing. Indices, ascending.
std::vector<int> shared_junctions(const Network& network, const std::vector<int>& edges);

/// Whether an edge has a lane for vehicles or trains, so that it is more than a footway.
bool is_road(const Network& network, int edge);

/// Whether a crossing leads over an edge with a lane for vehicles only.
bool leads_over_carriageway(const Network& network, int crossing);

/// The junction that an edge inside a junction belongs to: the id between ':' and the last '_'.
std::string junction_of(const Edge& inner);

}  // namespace pedzone
