// Pictures as PNG, by librsvg's command.
#pragma once

#include <string>

namespace pedzone {

/// The picture as a PNG file, `width` [pixels] wide. Throws InputError where rsvg-convert is not
/// installed, std::runtime_error where it fails.
std::string png_from_svg(const std::string& svg, int width);

}  // namespace pedzone
