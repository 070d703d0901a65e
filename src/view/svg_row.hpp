// Pictures beside each other.
#pragma once

#include <string>
#include <vector>

namespace pedzone {

struct NamedPicture {
  std::string name;  ///< plain text, written above it
  std::string svg;   ///< as SvgPage::finish() makes it
};

/// One SVG file with the pictures in a row, all as high as the first.
std::string svg_row(const std::vector<NamedPicture>& pictures);

/// The same one above the other, all as wide as the first.
std::string svg_column(const std::vector<NamedPicture>& pictures);

/// Whether pictures like this one had better be in a column than in a row.
bool is_wide(const std::string& svg);

}  // namespace pedzone
