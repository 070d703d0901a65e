#include "view/grid_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pages/palette.hpp"
#include "view/axis.hpp"
#include "view/colours.hpp"
#include "view/svg.hpp"
#include "view/zone_map.hpp"

namespace pedzone {
namespace {

constexpr double kMostCells = 150.0;  // along a map's side: as many as a map's width can show
constexpr std::size_t kBounds = 6;    // between the classes of colour

std::size_t class_of(double value, const std::vector<double>& bounds) {
  const auto above = std::ranges::upper_bound(bounds, value);
  return static_cast<std::size_t>(above - bounds.begin());
}

/// Dark where it is much.
std::string class_colour(std::size_t index, std::size_t bounds) {
  return scale_colour(1.0 - static_cast<double>(index) / static_cast<double>(bounds));
}

/// All cells of a class as one path.
std::string cells_svg(const ValueGrid& grid, const Box& box, const std::vector<double>& bounds) {
  std::vector<std::string> paths(bounds.size() + 1);
  for (const auto& [cell, value] : grid.cells) {
    if (value <= 0.0) continue;
    const double x = grid.size * cell.first - box.min().x();
    const double y = box.max().y() - grid.size * (cell.second + 1);
    paths[class_of(value, bounds)] +=
        fmt::format("M{0:g} {1:g}h{2:g}v{2:g}h-{2:g}z", x, y, grid.size);
  }
  std::string svg;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].empty()) continue;
    svg += fmt::format(R"(<path fill="{}" fill-opacity="0.85" d="{}"/>)",
                       class_colour(i, bounds.size()), paths[i]);
  }
  return svg;
}

std::string scale_bar_svg(const Box& box) {
  constexpr double kMostPart = 0.25;
  const double length = round_length(kMostPart * box.sizes().x());
  const double unit = box.sizes().x() / 100.0;
  const double x = 2.0 * unit, y = box.sizes().y() - 2.0 * unit;
  return fmt::format(R"(<path d="M{0:.2f} {1:.2f}h{2:.2f}" stroke="{6}" stroke-width="{3:.2f}"/>)"
                     R"(<text x="{0:.2f}" y="{4:.2f}" font-size="{5:.2f}" fill="{6}" stroke="{7}" )"
                     R"(stroke-width="{3:.2f}" paint-order="stroke">{2:g} m</text>)",
                     x, y, length, 0.5 * unit, y - 1.2 * unit, 3.6 * unit, colours::kInk,
                     colours::kPaper);
}

}  // namespace

ValueGrid::Cell ValueGrid::cell_at(const Vec2& at) const {
  return {static_cast<int>(std::floor(at.x() / size)), static_cast<int>(std::floor(at.y() / size))};
}

Box ValueGrid::box() const {
  Box all;
  for (const auto& [cell, value] : cells) {
    const Vec2 corner(size * cell.first, size * cell.second);
    all.extend(corner);
    all.extend(Vec2(corner + Vec2(size, size)));
  }
  return all;
}

double cell_for(const Box& box, double size) {
  return size * std::max(1.0, std::ceil(box.sizes().maxCoeff() / (kMostCells * size)));
}

ValueGrid coarsened(const ValueGrid& grid, const Box& box) {
  const double size = cell_for(box, grid.size);
  if (size <= grid.size) return grid;
  const double factor = size / grid.size;
  ValueGrid coarse(size, grid.per_area);
  for (const auto& [cell, value] : grid.cells) {
    const Vec2 middle = grid.size * Vec2(cell.first + 0.5, cell.second + 0.5);
    coarse.add(middle, grid.per_area ? value / (factor * factor) : value);
  }
  return coarse;
}

ValueGrid highest_of(const ValueGrid& grid, double size) {
  ValueGrid coarse(size, grid.per_area);
  for (const auto& [cell, value] : grid.cells) {
    const Vec2 middle = grid.size * Vec2(cell.first + 0.5, cell.second + 0.5);
    double& highest = coarse.cells[coarse.cell_at(middle)];
    highest = std::max(highest, value);
  }
  return coarse;
}

std::vector<double> class_bounds(std::span<const ValueGrid> grids) {
  constexpr double kBelow = 0.9;  // numerical: a round number's part from which the next is smaller
  double most = 0.0;
  for (const ValueGrid& grid : grids) {
    for (const auto& [cell, value] : grid.cells) most = std::max(most, value);
  }
  if (most <= 0.0) return {};
  std::vector<double> bounds;
  for (double bound = round_length(most); bounds.size() < kBounds;
       bound = round_length(kBelow * bound)) {
    bounds.insert(bounds.begin(), bound);
  }
  return bounds;
}

std::vector<MapClass> map_classes(const std::vector<double>& bounds) {
  std::vector<MapClass> classes;
  for (std::size_t i = 0; i <= bounds.size() && !bounds.empty(); ++i) {
    const std::string text = i == 0 ? fmt::format("below {:g}", bounds.front())
                             : i == bounds.size()
                                 ? fmt::format("{:g} and more", bounds.back())
                                 : fmt::format("{:g} to {:g}", bounds[i - 1], bounds[i]);
    classes.push_back({class_colour(i, bounds.size()), text});
  }
  return classes;
}

std::string ground_svg(const Place* place, const Box& box, const std::string& id) {
  SvgPage page(box, 0.0);
  if (place != nullptr) draw_zone_map(page, place->network, place->zones);
  std::string svg = page.finish("");
  svg.erase(0, svg.find("<svg"));
  return svg.insert(svg.find(' '), fmt::format(R"( id="{}")", id));
}

std::string map_svg(const ValueGrid& grid, const Box& box, const std::vector<double>& bounds,
                    const std::string& ground, const std::string& label, const std::string& more) {
  const Vec2 size = box.sizes();
  return fmt::format(R"(<svg class="map" role="img" aria-label="{}" viewBox="0 0 {:.2f} {:.2f}">)"
                     R"(<use href="#{}" width="{:.2f}" height="{:.2f}"/>{}{}{}</svg>)",
                     escaped(label), size.x(), size.y(), ground, size.x(), size.y(),
                     cells_svg(grid, box, bounds), more, scale_bar_svg(box));
}

}  // namespace pedzone
