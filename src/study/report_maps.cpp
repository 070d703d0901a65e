#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/csv_stream.hpp"
#include "core/error.hpp"
#include "output/conflict_reader.hpp"
#include "study/report_numbers.hpp"
#include "study/report_parts.hpp"
#include "sumo/scenario.hpp"
#include "view/axis.hpp"
#include "view/colours.hpp"
#include "view/place.hpp"
#include "view/zone_map.hpp"

namespace pedzone::report {
namespace {

constexpr double kCell = 2.0;          // [m] of density.csv
constexpr double kConflictCell = 4.0;  // [m] one lane and the person beside it
constexpr double kMostCells = 150.0;   // along a map's side: as many as a map's width can show
constexpr double kMargin = 8.0;        // [m] round what is shown
constexpr std::size_t kClasses = 6;    // of colour
constexpr std::string_view kGround[] = {"#f1f2ef"};
constexpr MapLook kLook{kGround, "#c3c6c0", "#c4beb6", "#a49d93", "#e2e3e1", "#eae7df", "#eceeee"};

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
  constexpr NumberRange kAny{-1e12, 1e12};
  const std::string file = folder + "/series.csv";
  if (!std::filesystem::exists(file)) return 0.0;
  std::vector<double> times;
  visit_rows(file, {"time", "persons", "personSpeed", "density", "vehicles", "vehicleSpeed"},
             [&](const CsvRow& row) { times.push_back(row.number(0, kAny)); });
  if (times.size() < 2) return 0.0;
  return times.back() - times.front() + times[1] - times[0];
}

/// Persons per square metre, mean over time and runs.
Grid density(const std::vector<std::string>& folders) {
  constexpr NumberRange kPlace{-1e9, 1e9}, kAmount{0.0, 1e12};
  Grid grid(kCell, true);
  double seconds = 0.0;
  for (const std::string& folder : folders) {
    const std::string file = folder + "/density.csv";
    if (!std::filesystem::exists(file)) continue;
    seconds += duration(folder);
    visit_rows(file, {"x", "y", "personSeconds"}, [&](const CsvRow& row) {
      const Vec2 corner(row.number(0, kPlace), row.number(1, kPlace));
      grid.add(corner + Vec2(kCell, kCell) / 2.0, row.number(2, kAmount));
    });
  }
  for (auto& [cell, value] : grid.cells) value /= std::max(seconds, 1.0) * kCell * kCell;
  return grid;
}

std::optional<Vec2> place_of(const Conflict& conflict) {
  for (const auto* extreme :
       {&conflict.contact, &conflict.ttc, &conflict.pet, &conflict.drac, &conflict.clearance}) {
    if (*extreme) return (*extreme)->position;
  }
  return {};
}

/// Conflicts a run.
Grid conflicts(const std::vector<std::string>& folders) {
  Grid grid(kConflictCell, false);
  std::size_t runs = 0;
  for (const std::string& folder : folders) {
    const std::string file = folder + "/conflicts.csv";
    if (!std::filesystem::exists(file)) continue;
    ++runs;
    visit_conflicts(file, [&](const Conflict& one) {
      if (const auto at = place_of(one)) grid.add(*at, 1.0);
    });
  }
  for (auto& [cell, value] : grid.cells)
    value /= static_cast<double>(std::max<std::size_t>(runs, 1));
  return grid;
}

// How they are drawn

/// Ascending upper bounds of the classes, one scale for all models: each twice the one before.
std::vector<double> class_bounds(const std::vector<Grid>& grids) {
  double most = 0.0;
  for (const Grid& grid : grids) {
    for (const auto& [cell, value] : grid.cells) most = std::max(most, value);
  }
  if (most <= 0.0) return {};
  // A round bound that all but the last class stay below.
  double bound = round_length(most);
  std::vector<double> bounds;
  for (std::size_t i = 0; i < kClasses; ++i) {
    bounds.insert(bounds.begin(), bound);
    bound /= 2.0;
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
    const std::string text =
        i == 0 ? "below " + digits_text(bounds.front())
        : i == bounds.size()
            ? digits_text(bounds.back()) + " and more"
            : fmt::format("{} to {}", digits_text(bounds[i - 1]), digits_text(bounds[i]));
    entries.push_back({{"colour", class_colour(i)}, {"text", text}});
  }
  return entries;
}

// One condition

/// The place of a condition, as its runs had it; null where it cannot be read any more.
std::unique_ptr<Place> place_of(const Input& input, std::size_t condition,
                                const std::string& folder) {
  const Study& study = input.plan.study;
  const StudyScenario& scenario = study.scenarios[input.plan.conditions[condition].scenario];
  try {
    auto place = std::make_unique<Place>();
    place->network = read_scenario_network(read_any_scenario(study.resolve(scenario.file), {}));
    ZoneFile zones;
    const std::string zone_file = folder + "/zone.zone.xml";
    if (std::filesystem::exists(zone_file)) zones = read_zone_file(zone_file);
    place->zones = build_zones(place->network, zones.zones);
    return place;
  } catch (const InputError&) {
    return nullptr;  // the maps do without their ground
  }
}

/// The ground as a picture of its own, to be used by the condition's maps.
std::string ground_svg(const Place* place, const Box& box, const std::string& id) {
  SvgPage page(box, 0.0);
  if (place != nullptr) draw_zone_map(page, place->network, place->zones, kLook);
  std::string svg = page.finish("");
  svg.erase(0, svg.find("<svg"));
  return svg.insert(svg.find(' '), fmt::format(R"( id="{}")", id));
}

struct Kind {
  const char *title, *caption;
  Grid (*grid)(const std::vector<std::string>&);
};
constexpr Kind kKinds[] = {
    {"Density of people", "Persons per m², mean over the time of a run and over all seeds.",
     density},
    {"Conflicts", "Conflicts a run, mean over all seeds, where bodies touched or would have.",
     conflicts},
};

Json condition_maps(const Input& input, std::size_t condition) {
  const std::vector<std::string>& models = input.plan.study.models;
  std::vector<std::vector<std::string>> folders;
  std::string any;
  for (const std::string& model : models) {
    folders.push_back(run_folders(input, condition, model));
    if (any.empty() && !folders.back().empty()) any = folders.back().front();
  }
  if (any.empty()) return Json::array();
  Box box;
  std::vector<std::vector<Grid>> grids;
  for (const Kind& kind : kKinds) {
    grids.emplace_back();
    for (const auto& of_model : folders) {
      grids.back().push_back(kind.grid(of_model));
      box.extend(grids.back().back().box());
    }
  }
  if (box.isEmpty()) return Json::array();
  box = grown(box, kMargin);
  for (std::vector<Grid>& of_kind : grids) {
    for (Grid& grid : of_kind) grid = coarsened(grid, box);
  }
  const std::string ground = fmt::format("ground-{}", condition);
  const std::unique_ptr<Place> place = place_of(input, condition, any);
  Json maps = Json::array();
  for (std::size_t k = 0; k < std::size(kKinds); ++k) {
    const std::vector<double> bounds = class_bounds(grids[k]);
    if (bounds.empty()) continue;
    Json pictures = Json::array();
    for (std::size_t m = 0; m < models.size(); ++m) {
      pictures.push_back(
          {{"model", models[m]},
           {"svg_html", map_svg(grids[k][m], box, bounds, ground,
                                fmt::format("{}: {}", kKinds[k].title, models[m]))}});
    }
    maps.push_back({{"title", kKinds[k].title},
                    {"caption", kKinds[k].caption},
                    {"legend", legend(bounds)},
                    {"pictures", pictures}});
  }
  return {{"ground_html", ground_svg(place.get(), box, ground)}, {"kinds", maps}};
}

}  // namespace

Json maps_part(const Input& input) {
  Json all = Json::array();
  for (std::size_t i = 0; i < input.plan.conditions.size(); ++i) {
    all.push_back(condition_maps(input, i));
  }
  return all;
}

}  // namespace pedzone::report
