// The polygons of the map that matter to a zone: what blocks the way, and what may be walked on.
#pragma once

#include <string>
#include <vector>

#include "zone/shapes.hpp"
#include "zone/zone_file.hpp"

namespace pedzone {

/// A polygon of the map, repaired.
struct ShapedPolygon {
  std::string id;
  Region region;
  Box box;
};

struct ZonePolygons {
  std::vector<ShapedPolygon> obstacles;  ///< building, jupedsim.obstacle, pedzone.obstacle
  std::vector<ShapedPolygon> water;      ///< no open space; bridges lead over it
  std::vector<ShapedPolygon> walkable;   ///< jupedsim.walkable_area, pedzone.walkable, named ones
};

/// Whether the polygon is ground that a zone of that spec may use.
bool is_walkable(const MapPolygon& polygon, const ZoneSpec& spec);

/// Sorts the network's polygons by what they mean; obstacles and water only where their box meets
/// `near` or a walkable polygon. Those that cross themselves are repaired, those without an area
/// left out, with a warning. Throws InputError for polygons that the zone file names and that are
/// unknown, have no area or cross themselves.
ZonePolygons sort_polygons(const Network& network, const ZoneSpec& spec, const Box& near,
                           std::vector<std::string>& warnings);

}  // namespace pedzone
