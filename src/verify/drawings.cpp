#include "verify/drawings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "view/colours.hpp"
#include "zone/shapes.hpp"

namespace pedzone::verify {
namespace {

constexpr double kUnits =
    100.0;  // numerical: units of a picture in a metre, so that paths are short

/// Places of a picture: y down, whole units.
struct Frame {
  Vec2 low, high;  ///< [m]

  long x(double metres) const { return std::lround((metres - low.x()) * kUnits); }
  long y(double metres) const { return std::lround((high.y() - metres) * kUnits); }
  long size(double metres) const { return std::lround(metres * kUnits); }

  std::string open(std::string_view name) const {
    return fmt::format(R"(<svg class="{}" viewBox="0 0 {} {}" role="img">)", name,
                       size(high.x() - low.x()), size(high.y() - low.y()));
  }
  std::string path(const std::vector<Vec2>& line, bool closed) const {
    std::string text;
    for (const Vec2& point : line) {
      text += fmt::format("{}{} {}", text.empty() ? "M" : "L", x(point.x()), y(point.y()));
    }
    return closed ? text + "Z" : text;
  }
  std::string path(const Region& region) const {
    std::string text;
    for (const Polygon& polygon : region) {
      text += path(polygon.outer, true);
      for (const Ring& hole : polygon.holes) text += path(hole, true);
    }
    return text;
  }
};

/// A line with a head at its end; `size` [m] of the head.
std::string arrow_path(const Frame& frame, const Drawing::Arrow& arrow, double size) {
  const Vec2 way = (arrow.to - arrow.from).normalized();
  const Vec2 left = arrow.to - size * way + 0.6 * size * left_of(way);
  const Vec2 right = arrow.to - size * way - 0.6 * size * left_of(way);
  return frame.path({arrow.from, arrow.to}, false) + frame.path({left, arrow.to, right}, false);
}

/// A length that the picture's scale shows [m].
double scale_length(double width) {
  for (const double length : {1.0, 2.0, 5.0, 10.0}) {
    if (length > 0.12 * width) return length;
  }
  return 20.0;
}

std::string scale_bar(const Frame& frame, const Vec2& at, double text_size) {
  const double length = scale_length(frame.high.x() - frame.low.x());
  const Vec2 end = at + Vec2(length, 0.0);
  return fmt::format(R"(<path class="scale" stroke-width="{}" d="{}"/>)",
                     frame.size(0.14 * text_size), frame.path({at, end}, false)) +
         fmt::format(R"(<text x="{}" y="{}" font-size="{}">{:g} m</text>)",
                     frame.x(end.x() + 0.3 * text_size), frame.y(at.y() - 0.3 * text_size),
                     frame.size(text_size), length);
}

// Maps

/// From these densities on [persons/m²] a map has the next colour: its own steps, none below the
/// first.
constexpr double kSteps[] = {0.1, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0};

std::size_t step_of(double density) {
  return static_cast<std::size_t>(std::ranges::upper_bound(kSteps, density) - std::begin(kSteps));
}

/// Light where few are: the dark end of the scale is for crowds.
std::string step_colour(std::size_t step) {
  const double part = static_cast<double>(step - 1) / static_cast<double>(std::size(kSteps) - 1);
  return scale_colour(1.0 - part);
}

/// Cells of that step, neighbours of a row together.
std::string step_path(const GridMap& map, std::size_t step) {
  std::string path;
  for (std::size_t row = 0; row < map.rows; ++row) {
    for (std::size_t column = 0; column < map.columns; ++column) {
      const auto is = [&](std::size_t at) {
        return step_of(map.values[row * map.columns + at]) == step;
      };
      if (!is(column)) continue;
      std::size_t end = column + 1;
      while (end < map.columns && is(end)) ++end;
      path +=
          fmt::format("M{} {}h{}v1h-{}z", column, map.rows - 1 - row, end - column, end - column);
      column = end;
    }
  }
  return path;
}

}  // namespace

std::string drawing_svg(const Drawing& drawing) {
  const Box extent = box_of(drawing.walkable);
  const Vec2 size = extent.sizes();
  const double unit_size = std::max(size.x(), 2.2 * size.y()) / 100.0;  // [m] of line widths
  const double rim = 2.0 * unit_size, text_size = 4.5 * unit_size;
  const Vec2 below(0.0, 1.8 * text_size);
  const Frame frame{extent.min() - Vec2(rim, rim) - below, extent.max() + Vec2(rim, rim)};
  const long thin = frame.size(0.35 * unit_size), thick = frame.size(0.7 * unit_size);
  std::string svg = frame.open("setup-drawing");
  svg += fmt::format(R"(<path class="ground" stroke-width="{}" d="{}"/>)", thick,
                     frame.path(drawing.walkable));
  for (const Drawing::Start& start : drawing.starts) {
    svg += fmt::format(R"(<path class="start stream-{}" d="{}"/>)", start.stream,
                       frame.path(start.area, true));
  }
  for (const Ring& area : drawing.measured) {
    svg +=
        fmt::format(R"(<path class="measured" stroke-width="{}" stroke-dasharray="{} {}" d="{}"/>)",
                    thin, 4 * thin, 3 * thin, frame.path(area, true));
  }
  for (const Polyline& line : drawing.lines) {
    svg += fmt::format(R"(<path class="line" stroke-width="{}" stroke-dasharray="{} {}" d="{}"/>)",
                       thick, thick, thick, frame.path(line, false));
  }
  for (const Drawing::Arrow& arrow : drawing.arrows) {
    svg += fmt::format(R"(<path class="arrow stream-{}" stroke-width="{}" d="{}"/>)", arrow.stream,
                       thick, arrow_path(frame, arrow, 3.0 * unit_size));
  }
  svg += scale_bar(frame, {extent.min().x(), extent.min().y() - rim - 0.6 * text_size}, text_size);
  return svg + "</svg>";
}

std::string map_svg(const GridMap& map) {
  std::string svg =
      fmt::format(R"(<svg class="map" viewBox="0 0 {} {}" role="img">)", map.columns, map.rows);
  for (std::size_t step = 1; step <= std::size(kSteps); ++step) {
    const std::string path = step_path(map, step);
    if (path.empty()) continue;
    svg += fmt::format(R"(<path fill="{}" d="{}"/>)", step_colour(step), path);
  }
  return svg + "</svg>";
}

std::vector<std::pair<std::string, std::string>> map_legend() {
  std::vector<std::pair<std::string, std::string>> legend;
  for (std::size_t step = 1; step <= std::size(kSteps); ++step) {
    legend.emplace_back(step_colour(step), fmt::format("from {:g}", kSteps[step - 1]));
  }
  legend.back().second += " persons/m²";
  return legend;
}

}  // namespace pedzone::verify
