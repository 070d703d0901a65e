// A zone's walkable area: the union of its shapes, minus obstacles, plus open space, with every
// way that SUMO's persons walk kept open.
#pragma once

#include <string>
#include <vector>

#include "zone/links.hpp"
#include "zone/obstacles.hpp"
#include "zone/open_space.hpp"
#include "zone/selection.hpp"

namespace pedzone {

/// What a zone consists of, in the network's terms.
struct ZoneParts {
  Selection selection;
  std::vector<Link> links;
  std::vector<int> inner_lanes;       ///< of junctions, ascending
  std::vector<int> shared_junctions;  ///< ascending
};

struct WalkableArea {
  Region walkable;
  Region obstacles;  ///< as far as they were not cut open
};

/// Builds the area.
///  - An obstacle that cuts a lane's centre line is cut open along it, unless the lane is so wide
///    that a broad passage remains beside it. Obstacles that together leave no room for a body are
///    cut too.
///  - Passages between edges that obstacles or gaps interrupt are mended by a straight corridor.
///  - Islands without any lane of the zone are dropped.
/// Each cut gives a warning that names the polygon and the lane or edges.
WalkableArea build_walkable_area(const Network& network, const ZoneSpec& spec,
                                 const ZoneParts& parts, const std::vector<bool>& in_a_zone,
                                 std::vector<std::string>& warnings);

}  // namespace pedzone
