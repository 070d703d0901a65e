// Maps of a value in square cells, coloured by class: one scale for all that are compared.
#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "results/place.hpp"
#include "zone/shapes.hpp"

namespace pedzone {

/// A value for each cell.
struct ValueGrid {
  using Cell = std::pair<int, int>;  ///< column and row
  double size;                       ///< [m] > 0
  bool per_area;                     ///< larger cells have the mean of smaller ones, else their sum
  std::map<Cell, double> cells;

  ValueGrid(double cell_size, bool of_area) : size(cell_size), per_area(of_area) {}
  Cell cell_at(const Vec2& at) const;
  void add(const Vec2& at, double value) { cells[cell_at(at)] += value; }
  Box box() const;
};

/// [m] a multiple of `size`: so large that a picture of the box can show the cells.
double cell_for(const Box& box, double size);
/// The same with cells that a picture of the box can show.
ValueGrid coarsened(const ValueGrid& grid, const Box& box);

/// The same in cells of `size` [m], each with the highest value of any in it.
ValueGrid highest_of(const ValueGrid& grid, double size);

/// Ascending bounds between the classes of colour, round numbers; none where all is nothing.
std::vector<double> class_bounds(std::span<const ValueGrid> grids);

struct MapClass {
  std::string colour, text;
};
/// For a legend: "below 0.1", "0.1 to 0.2", ... Dark where it is much.
std::vector<MapClass> map_classes(const std::vector<double>& bounds);

/// The ground as a picture of its own, which maps take by its id. `place`: null where not known.
std::string ground_svg(const Place* place, const Box& box, const std::string& id);

/// A map: the ground, the cells that are not 0, `more` (SVG in the box's frame, y down), a scale
/// bar. `label` is escaped here.
std::string map_svg(const ValueGrid& grid, const Box& box, const std::vector<double>& bounds,
                    const std::string& ground, const std::string& label,
                    const std::string& more = "");

}  // namespace pedzone
