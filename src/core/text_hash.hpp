// Hashes texts for tables that are asked with a view of one.
#pragma once

#include <functional>
#include <string_view>

namespace pedzone {

/// With std::equal_to<> as the other argument of a table, nothing is copied to look for a view.
struct TextHash : std::hash<std::string_view> {
  using is_transparent = void;
};

}  // namespace pedzone
