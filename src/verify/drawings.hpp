// Small pictures of the page: set-ups and density maps. They hold no text from outside.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verify/standard_test.hpp"

namespace pedzone::verify {

/// The set-up as an <svg> element, coloured by classes of the page's style sheet.
std::string drawing_svg(const Drawing& drawing);

/// A density map as an <svg> element.
std::string map_svg(const GridMap& map);

/// Colours and what they stand for, of all maps.
std::vector<std::pair<std::string, std::string>> map_legend();

}  // namespace pedzone::verify
