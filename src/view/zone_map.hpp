// The ground of a map: zones with their obstacles, and the roads round them.
#pragma once

#include <span>
#include <string_view>

#include "view/svg.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// Colours as SVG writes them.
struct MapLook {
  std::span<const std::string_view> zones;  ///< taken in turn
  std::string_view border;                  ///< of what is walkable
  std::string_view obstacle, obstacle_border;
  std::string_view road, footway, crossing;  ///< that stay SUMO's
  double line = 0.25;                        ///< [m] width of borders

  std::string walkable_style(std::size_t zone) const;
  std::string obstacle_style() const;
};

/// `colour` and a width [m] as SVG's attributes.
std::string stroke(std::string_view colour, double width);

/// Draws what lies in the page's box.
void draw_zone_map(SvgPage& page, const Network& network, std::span<const Zone> zones,
                   const MapLook& look);

}  // namespace pedzone
