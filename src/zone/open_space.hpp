// The space between the houses: what lies round a zone's lanes and can be reached from them
// without passing through a building or over a road that stays SUMO's.
#pragma once

#include <vector>

#include "zone/obstacles.hpp"
#include "zone/selection.hpp"

namespace pedzone {

/// Open space round highway.pedestrian edges where the user says nothing [m]. Given by the task;
/// OSM gives such streets 2 m of width.
constexpr double kOpenSpaceByDefault = 12.0;

/// How far open space reaches from which lanes.
struct OpenSpaceReach {
  double distance = 0.0;   ///< [m]; 0: none
  std::vector<int> lanes;  ///< Network lanes, ascending
};

/// What a zone file says, or the default: kOpenSpaceByDefault from highway.pedestrian lanes.
OpenSpaceReach open_space_reach(const Network& network, const ZoneSpec& spec,
                                const Selection& selection);

/// Roads that bound the open space of a zone within `near`: the lanes of roads that are not in it
/// and of other zones' edges, and the junctions of those roads, as far as they are on the level
/// of the zone.
Region bounding_roads(const Network& network, const Selection& selection,
                      const std::vector<bool>& in_a_zone, const Box& near);

/// `base` and all open space within reach of it. `blocked` is what cannot be passed.
Region with_open_space(const Network& network, const OpenSpaceReach& reach, const Region& base,
                       const Region& blocked);

}  // namespace pedzone
