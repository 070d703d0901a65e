// What lies below a map: its legend and its scale.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "view/svg.hpp"

namespace pedzone {

/// One line of a legend: draws its sign into a box of the page, before its name.
struct LegendEntry {
  std::string name;
  std::function<void(SvgPage&, const Box&)> draw;
};
/// `style`: SVG's attributes.
LegendEntry area_entry(std::string name, const std::string& style);
LegendEntry line_entry(std::string name, const std::string& style);

/// Text that fits a column: the end of what is too long is left out. Counts UTF-8's characters.
std::string shortened(std::string_view text, std::size_t most);

class MapPanel {
 public:
  /// For a map of these sizes [m]. `narrow`: it will be shown some 500 pixels wide, in a column of
  /// a page. `head`: room left free above the legend, in units.
  MapPanel(const Vec2& map, std::vector<LegendEntry> legend, bool narrow, double head = 0.0);

  /// [m] a hundredth of the map, less where a column of the legend would not fit; of a narrow one
  /// as large as a column allows. Texts, signs and lines of the picture are multiples of it.
  double unit() const { return unit_; }
  double height() const;  ///< [m]

  /// Covers what reaches down out of the map.
  void draw(SvgPage& page) const;

 private:
  std::size_t rows() const;
  void draw_scale_bar(SvgPage& page) const;

  Vec2 map_;
  std::vector<LegendEntry> legend_;
  double head_, unit_;
};

}  // namespace pedzone
