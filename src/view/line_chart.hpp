// Charts of lines and bands over an axis, each named beside them.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/vec.hpp"

namespace pedzone {

/// A line in pieces; x ascends in each.
struct ChartLine {
  std::string name;
  std::string colour, dashes;  ///< as SVG writes them; dashes may be empty
  std::vector<Polyline> pieces;
};

/// What lies between two values at each x.
struct ChartBand {
  struct Point {
    double x, low, high;
  };
  std::string name, colour;
  std::vector<std::vector<Point>> pieces;
};

struct Chart {
  std::string title, x_label, y_label;  ///< labels with their units
  std::vector<ChartBand> bands;
  std::vector<ChartLine> lines;
  double y_most = std::numeric_limits<double>::infinity();  ///< larger values are cut off
  bool y_has_zero = true;
  std::string note = {};  ///< written into the chart, above
};

/// The chart as an SVG file. The y axis has 0 unless told otherwise. Nothing to draw: axes from 0
/// to 1.
std::string line_chart(const Chart& chart);

}  // namespace pedzone
