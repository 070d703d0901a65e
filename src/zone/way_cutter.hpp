// Keeps ways open: obstacles that cut a centre line or block a lane are cut open along it.
#pragma once

#include <string>
#include <vector>

#include "zone/obstacles.hpp"

namespace pedzone {

/// Width of a corridor where only passing matters [m]. assumed: two bodies side by side.
constexpr double kClearWidth = 1.2;

/// Cuts obstacles open along the centre lines of lanes (Network indices), in place. Whether an
/// obstacle is cut depends on the obstacles as they came, not on the order of lanes.
void cut_obstacles(const Network& network, const std::vector<int>& lanes,
                   std::vector<ShapedPolygon>& obstacles, std::vector<std::string>& warnings);

/// Takes a corridor out of the obstacles that it meets; returns their ids.
std::vector<std::string> clear_corridor(const Region& corridor,
                                        std::vector<ShapedPolygon>& obstacles);

}  // namespace pedzone
