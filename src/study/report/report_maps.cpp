#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/error.hpp"
#include "results/conflict_table.hpp"
#include "results/density_grid.hpp"
#include "results/place.hpp"
#include "results/run_tables.hpp"
#include "study/measure/conflict_measures.hpp"
#include "study/measure/run_measures.hpp"
#include "study/report/report_parts.hpp"
#include "study/report/run_recording.hpp"
#include "view/axis.hpp"
#include "view/colours.hpp"
#include "view/zone_map.hpp"

namespace pedzone::study::report {
namespace {

constexpr double kConflictCell = 4.0;  // [m] one lane and the person beside it
constexpr double kMostCells = 150.0;   // along a map's side: as many as a map's width can show
constexpr double kMargin = 8.0;        // [m] round what is shown
constexpr std::size_t kClasses = 6;    // of colour

using Cell = std::pair<int, int>;  // column and row
/// A value for each cell.
struct Grid {
  double size;    // [m]
  bool per_area;  // larger cells have the mean of smaller ones, else their sum
  std::map<Cell, double> cells;

  Grid(double cell_size, bool of_area) : size(cell_size), per_area(of_area) {}
  void add(const Vec2& at, double value) {
    cells[{static_cast<int>(std::floor(at.x() / size)),
           static_cast<int>(std::floor(at.y() / size))}] += value;
  }
  Box box() const {
    Box all;
    for (const auto& [cell, value] : cells) {
      const Vec2 corner(size * cell.first, size * cell.second);
      all.extend(corner);
      all.extend(Vec2(corner + Vec2(size, size)));
    }
    return all;
  }
};

/// The same with cells that a picture of the box can show.
Grid coarsened(const Grid& grid, const Box& box) {
  const double factor = std::ceil(box.sizes().maxCoeff() / (kMostCells * grid.size));
  if (factor <= 1.0) return grid;
  Grid coarse(factor * grid.size, grid.per_area);
  for (const auto& [cell, value] : grid.cells) {
    const Vec2 middle = grid.size * Vec2(cell.first + 0.5, cell.second + 0.5);
    coarse.add(middle, grid.per_area ? value / (factor * factor) : value);
  }
  return coarse;
}

// What the runs have left

/// [s] from the first to the end of the last interval of a run's series; 0 where it has none.
double duration(const std::string& folder) {
  const std::string file = folder + "/series.csv";
  if (!std::filesystem::exists(file)) return 0.0;
  std::vector<double> times;
  series_table().visit(file,
                       [&](const SeriesRow& row, const CsvRow&) { times.push_back(row.time); });
  if (times.size() < 2) return 0.0;
  return times.back() - times.front() + times[1] - times[0];
}

/// Persons per square metre, mean over time and runs.
Grid density(const std::vector<std::string>& folders) {
  Grid grid(kDensityCell, true);
  double seconds = 0.0;
  for (const std::string& folder : folders) {
    const std::string file = folder + "/density.csv";
    if (!std::filesystem::exists(file)) continue;
    seconds += duration(folder);
    density_table().visit(file, [&](const DensityRow& row, const CsvRow&) {
      grid.add(Vec2(row.x, row.y) + Vec2(kDensityCell, kDensityCell) / 2.0, row.person_seconds);
    });
  }
  for (auto& [cell, value] : grid.cells)
    value /= std::max(seconds, 1.0) * kDensityCell * kDensityCell;
  return grid;
}

/// Conflicts a run, as conflict.count has them.
Grid conflicts(const std::vector<std::string>& folders) {
  Grid grid(kConflictCell, false);
  std::size_t runs = 0;
  for (const std::string& folder : folders) {
    const std::string file = folder + "/" + kZoneConflicts;
    if (!std::filesystem::exists(file)) continue;
    ++runs;
    conflict_table().visit(file, [&](const Conflict& one, const CsvRow&) {
      const bool counts = with_moving_vehicle(one) && !is_insertion(one);
      if (counts) grid.add(moment_of(one).position, 1.0);
    });
  }
  for (auto& [cell, value] : grid.cells)
    value /= static_cast<double>(std::max<std::size_t>(runs, 1));
  return grid;
}

// How they are drawn

/// Ascending bounds between the classes, round numbers: one scale for all models and conditions.
std::vector<double> class_bounds(const std::vector<Grid>& grids) {
  constexpr double kBelow = 0.9;  // numerical: a round number's part from which the next is smaller
  double most = 0.0;
  for (const Grid& grid : grids) {
    for (const auto& [cell, value] : grid.cells) most = std::max(most, value);
  }
  if (most <= 0.0) return {};
  std::vector<double> bounds;
  for (double bound = round_length(most); bounds.size() < kClasses;
       bound = round_length(kBelow * bound)) {
    bounds.insert(bounds.begin(), bound);
  }
  return bounds;
}

std::size_t class_of(double value, const std::vector<double>& bounds) {
  const auto above = std::ranges::upper_bound(bounds, value);
  return static_cast<std::size_t>(above - bounds.begin());
}

/// Dark where it is much.
std::string class_colour(std::size_t index) {
  return scale_colour(1.0 - static_cast<double>(index) / static_cast<double>(kClasses));
}

/// All cells of a class as one path.
std::string cells_svg(const Grid& grid, const Box& box, const std::vector<double>& bounds) {
  std::vector<std::string> paths(kClasses + 1);
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
    svg +=
        fmt::format(R"(<path fill="{}" fill-opacity="0.85" d="{}"/>)", class_colour(i), paths[i]);
  }
  return svg;
}

std::string scale_bar_svg(const Box& box) {
  constexpr double kMostPart = 0.25;
  const double length = round_length(kMostPart * box.sizes().x());
  const double unit = box.sizes().x() / 100.0;
  const double x = 2.0 * unit, y = box.sizes().y() - 2.0 * unit;
  return fmt::format(
      R"(<path d="M{0:.2f} {1:.2f}h{2:.2f}" stroke="#222222" stroke-width="{3:.2f}"/>)"
      R"(<text x="{0:.2f}" y="{4:.2f}" font-size="{5:.2f}" fill="#222222" stroke="#ffffff" )"
      R"(stroke-width="{3:.2f}" paint-order="stroke">{2:g} m</text>)",
      x, y, length, 0.5 * unit, y - 1.2 * unit, 3.6 * unit);
}

std::string map_svg(const Grid& grid, const Box& box, const std::vector<double>& bounds,
                    const std::string& ground, const std::string& label) {
  const Vec2 size = box.sizes();
  return fmt::format(R"(<svg class="map" role="img" aria-label="{}" viewBox="0 0 {:.2f} {:.2f}">)"
                     R"(<use href="#{}" width="{:.2f}" height="{:.2f}"/>{}{}</svg>)",
                     escaped(label), size.x(), size.y(), ground, size.x(), size.y(),
                     cells_svg(grid, box, bounds), scale_bar_svg(box));
}

Json legend(const std::vector<double>& bounds) {
  Json entries = Json::array();
  for (std::size_t i = 0; i <= bounds.size(); ++i) {
    const std::string text = i == 0 ? fmt::format("below {:g}", bounds.front())
                             : i == bounds.size()
                                 ? fmt::format("{:g} and more", bounds.back())
                                 : fmt::format("{:g} to {:g}", bounds[i - 1], bounds[i]);
    entries.push_back({{"colour", class_colour(i)}, {"text", text}});
  }
  return entries;
}

// One scenario

/// The ground as a picture of its own, which all maps of a scenario use.
std::string ground_svg(const Place* place, const Box& box, const std::string& id) {
  SvgPage page(box, 0.0);
  if (place != nullptr) draw_zone_map(page, place->network, place->zones);
  std::string svg = page.finish("");
  svg.erase(0, svg.find("<svg"));
  return svg.insert(svg.find(' '), fmt::format(R"( id="{}")", id));
}

struct Kind {
  const char *title, *caption;
  Grid (*grid)(const std::vector<std::string>&);
};
constexpr Kind kKinds[] = {
    {"Density of people", "Persons per m²: mean over the time of a run and over all seeds.",
     density},
    {"Conflicts",
     "With moving vehicles, a run: mean over all seeds; where bodies touched, or would have.",
     conflicts},
};

/// What a condition's runs have left: a grid for each model.
struct ConditionGrids {
  std::size_t condition;
  std::vector<Grid> of_kind[std::size(kKinds)];
};

std::vector<ConditionGrids> read_grids(const Input& input, std::size_t scenario) {
  std::vector<ConditionGrids> all;
  for (std::size_t i = 0; i < pictured(input.plan); ++i) {
    if (input.plan.conditions[i].scenario != scenario) continue;
    all.push_back({i, {}});
    for (const std::string& model : input.plan.study.models) {
      const std::vector<std::string> folders = run_folders(input, i, model);
      for (std::size_t k = 0; k < std::size(kKinds); ++k) {
        all.back().of_kind[k].push_back(kKinds[k].grid(folders));
      }
    }
  }
  return all;
}

/// What all grids lie in, with some room; empty where there is nothing to show.
Box shown_box(const std::vector<ConditionGrids>& all) {
  Box box;
  for (const ConditionGrids& one : all) {
    for (const std::vector<Grid>& grids : one.of_kind) {
      for (const Grid& grid : grids) box.extend(grid.box());
    }
  }
  return box.isEmpty() ? box : grown(box, kMargin);
}

/// The place of a scenario's first finished run; null where it cannot be read any more.
const Place* place_of(const Input& input, RunPlaces& places,
                      const std::vector<ConditionGrids>& all) {
  for (const ConditionGrids& one : all) {
    const auto first = first_done_run(input, one.condition);
    if (!first) continue;
    const PlannedRun& run = input.plan.runs[*first];
    try {
      return &places.of(run, input.store.run_folder(run.id));
    } catch (const InputError&) {
      return nullptr;  // the maps do without their ground
    }
  }
  return nullptr;
}

Json kind_maps(const Kind& kind, const std::vector<Grid>& grids, const Box& box,
               const std::vector<double>& bounds, const std::string& ground,
               const std::vector<std::string>& models) {
  Json pictures = Json::array();
  for (std::size_t m = 0; m < models.size(); ++m) {
    const std::string label = fmt::format("{}: {}", kind.title, models[m]);
    pictures.push_back(
        {{"model", models[m]}, {"svg_html", map_svg(grids[m], box, bounds, ground, label)}});
  }
  return {{"title", kind.title},
          {"caption", kind.caption},
          {"legend", legend(bounds)},
          {"pictures", pictures}};
}

/// Puts the maps of a scenario's conditions into `conditions`, its ground into `grounds`, and a map
/// of nothing else into `areas`.
void add_scenario(const Input& input, std::size_t scenario, RunPlaces& places, Json& conditions,
                  Json& grounds, Json& areas) {
  std::vector<ConditionGrids> all = read_grids(input, scenario);
  const Box box = shown_box(all);
  if (box.isEmpty()) return;
  const std::string ground = fmt::format("ground-{}", scenario);
  grounds.push_back({{"svg_html", ground_svg(place_of(input, places, all), box, ground)}});
  const std::string& name = input.plan.study.scenarios[scenario].id;
  areas.push_back(
      {{"name", name}, {"svg_html", map_svg(Grid(1.0, false), box, {}, ground, "Area: " + name)}});
  for (std::size_t k = 0; k < std::size(kKinds); ++k) {
    std::vector<Grid> of_all;
    for (ConditionGrids& one : all) {
      for (Grid& grid : one.of_kind[k]) {
        grid = coarsened(grid, box);
        of_all.push_back(grid);
      }
    }
    const std::vector<double> bounds = class_bounds(of_all);
    if (bounds.empty()) continue;
    for (const ConditionGrids& one : all) {
      conditions[one.condition].push_back(
          kind_maps(kKinds[k], one.of_kind[k], box, bounds, ground, input.plan.study.models));
    }
  }
}

}  // namespace

Json maps_part(const Input& input) {
  Json conditions = Json::array(), grounds = Json::array(), areas = Json::array();
  for (std::size_t i = 0; i < pictured(input.plan); ++i) {
    conditions.push_back(Json::array());
  }
  RunPlaces places(input.plan);
  for (std::size_t i = 0; i < input.plan.study.scenarios.size(); ++i) {
    add_scenario(input, i, places, conditions, grounds, areas);
  }
  return {{"conditions", conditions}, {"grounds", grounds}, {"areas", areas}};
}

}  // namespace pedzone::study::report
