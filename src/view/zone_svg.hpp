// A picture of zones: walkable area, obstacles, lanes in the zones, roads outside, legend, scale
// bar; and of people's paths over it.
#pragma once

#include <string>
#include <vector>

#include "zone/zone.hpp"

namespace pedzone {

/// Lines to draw over the zones, such as the paths of people or of vehicles.
struct PathLayer {
  std::string name;             ///< for the legend
  std::string colour;           ///< as SVG writes it
  double width = 0.35;          ///< [m] > 0
  double opacity = 0.35;        ///< (0, 1] of one line; where many run, they add up
  std::vector<Polyline> lines;  ///< [m] those with fewer than two points are left out
};

/// The picture as an SVG file.
std::string zone_svg(const Network& network, const std::vector<Zone>& zones,
                     const std::vector<PathLayer>& layers = {});

}  // namespace pedzone
