// Figures of the page: as tables, and the key ones with their intervals.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "validation/page_parts.hpp"
#include "view/axis.hpp"

namespace pedzone::page {
namespace {

/// Neighbouring figures with a common heading.
struct Block {
  std::string_view title;
  std::size_t figures;
};
constexpr std::array<Block, 6> kBlocks{{{"Contact", 2},
                                        {"Smallest clearance", 3},
                                        {"Lateral deviation", 2},
                                        {"Speed", 3},
                                        {"Order and time", 8},
                                        {"Distance to recording", 2}}};
static_assert(std::accumulate(kBlocks.begin(), kBlocks.end(), std::size_t{0},
                              [](std::size_t sum, const Block& b) { return sum + b.figures; }) ==
              kFigures);

constexpr std::array kKeyFigures{std::pair{Figure::kClearance, "Smallest clearance, median [m]"},
                                 std::pair{Figure::kDeviation, "Lateral deviation, median [m]"},
                                 std::pair{Figure::kSpeed, "Mean speed, mean [m/s]"},
                                 std::pair{Figure::kLeastSpeed, "Least speed, median [m/s]"}};

/// A column's class: where a block begins there is a line.
std::string edge_of(std::size_t figure) {
  std::size_t begin = 0;
  for (const Block& block : kBlocks) {
    if (figure == begin) return "first";
    begin += block.figures;
  }
  return "";
}

std::string shown(const FigureInfo& info, double value) {
  return number(value * info.scale, info.digits);
}

std::string interval(const FigureInfo& info, const ValidationRow& row, std::size_t figure) {
  if (info.count || std::isnan(row.value[figure])) return "";
  if (std::isnan(row.low[figure]) || std::isnan(row.high[figure])) return "—";  // too few clips
  return shown(info, row.low[figure]) + "–" + shown(info, row.high[figure]);
}

/// A round number that no value and no upper end of an interval exceeds.
double end_of(const std::vector<const ValidationRow*>& rows, std::size_t figure) {
  double most = 0.0;
  for (const ValidationRow* row : rows) {
    for (const double value : {row->value[figure], row->high[figure]}) {
      if (std::isfinite(value)) most = std::max(most, value);
    }
  }
  const double step = round_step(most, 4.0);
  return step * std::max(1.0, std::ceil(most / step));
}

}  // namespace

Json table_blocks() {
  Json blocks = Json::array();
  for (const Block& block : kBlocks) {
    blocks.push_back({{"title", block.title}, {"figures", block.figures}});
  }
  return blocks;
}

Json table_columns() {
  Json columns = Json::array();
  for (const Block& block : kBlocks) {
    for (std::size_t k = 0; k < block.figures; ++k) {
      const std::size_t f = columns.size();
      const FigureInfo& info = figure_list()[f];
      columns.push_back({{"block", block.title},
                         {"edge", edge_of(f)},
                         {"title", info.title},
                         {"unit", info.unit},
                         {"scale", info.count          ? "persons"
                                   : info.unit.empty() ? "0–1"
                                                       : info.unit},
                         {"meaning", info.meaning}});
    }
  }
  return columns;
}

Json table_rows(const ValidationResult& result, PersonSet set, const std::string& group) {
  Json rows = Json::array();
  for (const ValidationRow* row : rows_of(result, set, group)) {
    Json cells = Json::array();
    for (std::size_t f = 0; f < kFigures; ++f) {
      const FigureInfo& info = figure_list()[f];
      cells.push_back({{"edge", edge_of(f)},
                       {"value", shown(info, row->value[f])},
                       {"interval", interval(info, *row, f)}});
    }
    const Json look = look_of(result, *row);
    rows.push_back({{"name", row->model},
                    {"look", look},
                    {"kind", look == "recorded"                 ? "recorded"
                             : look == result.models.size() - 1 ? "main"
                                                                : "other"},
                    {"cells", cells}});
  }
  return rows;
}

Json key_figures(const ValidationResult& result, PersonSet set, const std::string& group) {
  const auto rows = rows_of(result, set, group);
  Json figures = Json::array();
  for (const auto& [figure, title] : kKeyFigures) {
    const auto f = static_cast<std::size_t>(figure);
    Json values = Json::array();
    for (const ValidationRow* row : rows) {
      values.push_back({{"name", row->model},
                        {"look", look_of(result, *row)},
                        {"value", row->value[f]},
                        {"low", row->low[f]},
                        {"high", row->high[f]},
                        {"text", number(row->value[f], 2)}});
    }
    figures.push_back({{"title", title}, {"end", end_of(rows, f)}, {"rows", values}});
  }
  return figures;
}

}  // namespace pedzone::page
