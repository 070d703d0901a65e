// Which edges and lanes are shared space.
//
// By the rule, where the user names none: edges of type highway.pedestrian and
// highway.living_street, and lanes that the file opens to both persons and vehicles at no more
// than 20 km/h. Lanes that are merely not closed to persons (netconvert's default) and sidewalks
// stay SUMO's. An edge is in the zone when the lane that SUMO's persons walk on is. Stubs of paths,
// shorter than 2 m, come with the streets whose junctions they join.
#pragma once

#include <functional>
#include <vector>

#include "zone/network.hpp"
#include "zone/zone.hpp"
#include "zone/zone_file.hpp"

namespace pedzone {

/// Fastest speed limit of a lane that is shared space by the rule [m/s]: 20 km/h, rounded up as
/// netconvert writes it.
constexpr double kSharedSpaceSpeed = 5.6;

/// Edges of a zone and their lanes whose area is walkable: Network indices, ascending.
struct Selection {
  std::vector<int> edges, lanes;
};

/// Removes the edges for which `is_out`, and their lanes.
void leave_out(const Network& network, const std::function<bool(int edge)>& is_out,
               Selection& selection);

/// Whether an edge's type is `type`, or a compound of it as netconvert makes for ways with several
/// tags (highway.pedestrian|railway.tram).
bool has_type(const Edge& edge, std::string_view type);

/// Whether the rule above takes a lane.
bool is_shared_space(const Network& network, int lane);

/// The edges and lanes of a zone. `taken` marks edges of other zones, which are left to them.
/// Throws InputError for unknown edges, types and lanes, for those that persons may not use, and
/// when nothing is left.
Selection select_lanes(const Network& network, const ZoneSpec& spec,
                       const std::vector<bool>& taken);

/// Length by type of the edges of a zone.
std::vector<TypeLength> lengths_inside(const Network& network, const std::vector<int>& edges);

/// Length by type of the edges that persons may use and no zone has (`taken`), with the attribute
/// of a zone that would bring them in. Longest first, as lengths_inside.
std::vector<TypeLength> lengths_left_out(const Network& network, const std::vector<bool>& taken);

}  // namespace pedzone
