// Colours that colour-blind people tell apart, on a light background.
#pragma once

#include <string>
#include <string_view>

namespace pedzone {

/// A perceptually uniform scale from dark violet to light green, [0, 1]: viridis (Smith and van der
/// Walt 2015) without its lightest fifteenth, which is lost on white. Lightness rises throughout.
std::string scale_colour(double part);

/// How line `index` of several looks: colours of the palette that show on white, and
/// dashes once they have all been used.
struct LineLook {
  std::string_view colour, dashes;  ///< as SVG writes them, dashes in line widths; may be empty
};
LineLook line_look(std::size_t index);
/// So many looks differ.
inline constexpr std::size_t kLineLooks = 12;

}  // namespace pedzone
