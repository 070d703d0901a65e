#include "app/seen_crossings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "pages/palette.hpp"
#include "results/table.hpp"
#include "sumo/files/place_reader.hpp"
#include "sumo/files/scenario.hpp"
#include "view/line_chart.hpp"

namespace pedzone {
namespace {

using study::SeenCrossing;
constexpr int kDigits = 2;         // of all numbers
constexpr double kBin = 1.0;       // [s] of the chart
constexpr double kMostGap = 20.0;  // [s] of the chart: longer ones are all taken
constexpr double kCurveStep = 0.1; // [s]

const Table<SeenCrossing>& table() {
  using Row = SeenCrossing;
  static const Table<Row> table(
      {text_column({"person", "", "id"}, &Row::person),
       {{"place", "", "between the junctions, or at a junction", ColumnKind::kText},
        [](std::string& line, const Row& row) { line += row.between ? "between" : "junction"; }},
       number_column({"waited", "s", "standing at the kerb"}, &Row::waited, kDigits),
       number_column({"gap", "s", "that was taken; empty: no vehicle came after"}, &Row::gap,
                     kDigits),
       list_column({"let_pass", "s", "gaps, one after the other"}, &Row::let_pass, kDigits)});
  return table;
}

/// Share of the gaps in each second that were taken.
Polyline observed_shares(std::span<const GapChoice> choices) {
  std::vector<double> taken(static_cast<std::size_t>(kMostGap / kBin)), all(taken.size());
  for (const GapChoice& choice : choices) {
    if (choice.gap < 0.0 || choice.gap >= kMostGap) continue;
    const auto bin = static_cast<std::size_t>(choice.gap / kBin);
    all[bin] += 1.0;
    if (choice.taken) taken[bin] += 1.0;
  }
  Polyline line;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k] > 0.0) line.emplace_back((static_cast<double>(k) + 0.5) * kBin, taken[k] / all[k]);
  }
  return line;
}

std::string chart_of(std::span<const GapChoice> choices, const std::optional<GapAcceptance>& fit) {
  Chart chart;
  chart.title = "Gaps between vehicles that people take";
  chart.x_label = "gap [s]";
  chart.y_label = "share taken";
  chart.lines.push_back(
      {"counted, by seconds", std::string(colours::kBlue.light), "4 3", {observed_shares(choices)}});
  if (fit && std::isfinite(fit->slope)) {
    Polyline curve;
    for (double gap = 0.0; gap <= kMostGap; gap += kCurveStep) {
      curve.emplace_back(gap, fit->share(gap));
    }
    chart.lines.push_back(
        {"logistic regression", std::string(colours::kVermilion.light), "", {curve}});
    chart.note = fmt::format("half of them take {:.1f} s [{:.1f}, {:.1f}]; {} taken, {} let pass",
                             fit->median, fit->low, fit->high, fit->taken, fit->left);
  }
  return line_chart(chart);
}

std::string told(std::span<const SeenCrossing> all, const std::optional<GapAcceptance>& fit) {
  double waited = 0.0;
  const auto between = std::ranges::count(all, true, &SeenCrossing::between);
  for (const SeenCrossing& one : all) waited += one.waited;
  std::string text = fmt::format("Streets were crossed {} times, {} of them between the junctions",
                                 all.size(), between);
  if (between > 0) {
    text += fmt::format(" ({:.0f} %), after {:.1f} s at the kerb",
                        100.0 * static_cast<double>(between) / static_cast<double>(all.size()),
                        waited / static_cast<double>(between));
  }
  text += ".\n";
  if (fit) {
    text += fmt::format("Half of the people take a gap of {:.1f} s [{:.1f}, {:.1f}]: {} gaps were "
                        "taken, {} let pass.\n",
                        fit->median, fit->low, fit->high, fit->taken, fit->left);
  }
  return text;
}

std::unique_ptr<Place> place_with_streets(const std::string& scenario,
                                          const SeenCrossingOptions& options) {
  if (scenario.empty()) {
    throw InputError("needs --scenario", {.element = "option --zone", .value = options.zone_file});
  }
  auto place =
      std::make_unique<Place>(read_place(read_any_scenario(scenario, {}), options.zone_file));
  const bool any = std::ranges::any_of(
      place->zones, [](const Zone& zone) { return !zone.streets.empty(); });
  if (any) return place;
  throw InputError("has no street to watch",
                   {.element = "option --zone",
                    .value = options.zone_file,
                    .allowed = "a zone with crossing=\"anywhere\" and streets with ground for "
                               "people on both sides"});
}

}  // namespace

SeenCrossings::SeenCrossings(const std::string& scenario, const SeenCrossingOptions& options)
    : place_(place_with_streets(scenario, options)), crossings_(place_->zones) {
  if (!options.csv.empty()) csv_ = std::make_unique<CompleteFile>(options.csv, "--crossing-csv");
  if (!options.svg.empty()) svg_ = std::make_unique<CompleteFile>(options.svg, "--crossing-svg");
}

void SeenCrossings::step(double time, std::span<const PersonSample> persons,
                         std::span<const VehicleSample> vehicles) {
  crossings_.step(time, begun_ ? time - time_ : 0.0, persons, vehicles);
  begun_ = true;
  time_ = time;
}

std::string SeenCrossings::finish() {
  const std::vector<SeenCrossing> all = crossings_.all();
  const std::vector<GapChoice> choices = study::gap_choices(all);
  const std::optional<GapAcceptance> fit = fit_gap_acceptance(choices);
  if (csv_) {
    std::string text = table().header();
    for (const SeenCrossing& one : all) table().append(text, one);
    csv_->write(text);
  }
  if (svg_) svg_->write(chart_of(choices, fit));
  if (csv_) csv_->finish();
  if (svg_) svg_->finish();
  return told(all, fit);
}

}  // namespace pedzone
