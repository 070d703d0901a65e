#include <fmt/format.h>

#include <algorithm>
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
#include "view/grid_map.hpp"

namespace pedzone::study::report {
namespace {

constexpr double kConflictCell = 4.0;  // [m] one lane and the person beside it
constexpr double kMargin = 8.0;        // [m] round what is shown
using Grid = ValueGrid;

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

Json legend(const std::vector<double>& bounds) {
  Json entries = Json::array();
  for (const MapClass& one : map_classes(bounds)) {
    entries.push_back({{"colour", one.colour}, {"text", one.text}});
  }
  return entries;
}

// One scenario

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
