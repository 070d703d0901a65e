// The two axes of a chart with their grid, ticks and labels.
#pragma once

#include <string_view>

#include "view/axis.hpp"
#include "view/svg.hpp"

namespace pedzone {

/// Where axes and their texts lie, in units of the picture; y is up.
struct AxesLayout {
  Box frame = {};            ///< lower left: where the axes meet
  double tick_letters = 0;   ///< size of the ticks' letters
  double label_letters = 0;  ///< size of the labels' letters
  double x_tick_drop = 0;    ///< ticks' texts are so far below the x axis
  Vec2 y_tick_back = {};     ///< ... so far left of the y axis, and so far below their tick
  double x_label_height = 0, y_label_right = 0;  ///< labels are so far from the picture's edges
};

struct ChartAxes {
  Axis x, y;
  AxesLayout layout;

  /// The place of two values in the picture.
  Vec2 at(double x_value, double y_value) const;
  /// Lines at all ticks, to be drawn below everything else.
  void draw_grid(SvgPage& page) const;
  /// The axes, a line at y = 0 where that is above the x axis, ticks, labels (escaped here).
  void draw(SvgPage& page, std::string_view x_label, std::string_view y_label) const;
};

}  // namespace pedzone
