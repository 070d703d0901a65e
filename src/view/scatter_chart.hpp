// Points in a plane with two axes, both from 0.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/vec.hpp"

namespace pedzone {

/// As an <svg> element for a page. Labels are escaped here.
std::string scatter_chart(const std::vector<Vec2>& points, std::string_view x_label,
                          std::string_view y_label);

}  // namespace pedzone
