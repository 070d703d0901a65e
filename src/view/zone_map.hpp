// The ground of a map: zones with their obstacles, and the roads round them.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "view/svg.hpp"
#include "zone/zone.hpp"

namespace pedzone {

inline constexpr double kMapLine = 0.25;  ///< [m] usual width of borders

/// What is walkable of a zone, and obstacles, as SVG's attributes. `line` [m]: width of borders.
std::string walkable_style(std::size_t zone, double line = kMapLine);
std::string obstacle_style(double line = kMapLine);

/// SVG's attributes of an area of this colour, and of a line with a width [m].
std::string filled(std::string_view colour);
std::string stroke(std::string_view colour, double width);

/// Draws what lies in the page's box, in the palette's colours.
void draw_zone_map(SvgPage& page, const Network& network, std::span<const Zone> zones,
                   double line = kMapLine);

}  // namespace pedzone
