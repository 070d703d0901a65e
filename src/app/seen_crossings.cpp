#include "app/seen_crossings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "pages/palette.hpp"
#include "sumo/files/place_reader.hpp"
#include "sumo/files/scenario.hpp"
#include "view/line_chart.hpp"

namespace pedzone {
namespace {

constexpr double kCurveStep = 0.1;  // [s]

/// Share of the gaps in each second that were taken.
Polyline counted(std::span<const GapChoice> choices) {
  Polyline line;
  for (const GapShare& one : shares_taken(choices)) line.emplace_back(one.gap, one.share);
  return line;
}

std::string chart_of(std::span<const GapChoice> choices, const std::optional<GapAcceptance>& fit) {
  Chart chart;
  chart.title = "Gaps between vehicles that people take";
  chart.x_label = "gap [s]";
  chart.y_label = "share taken";
  chart.lines.push_back(
      {"counted, by seconds", std::string(colours::kBlue.light), "4 3", {counted(choices)}});
  if (fit && std::isfinite(fit->slope)) {
    Polyline curve;
    for (double gap = 0.0; gap <= kLongestGap; gap += kCurveStep) {
      curve.emplace_back(gap, fit->share(gap));
    }
    chart.lines.push_back(
        {"logistic regression", std::string(colours::kVermilion.light), "", {curve}});
    chart.note = fmt::format("half of them take {:.1f} s [{:.1f}, {:.1f}]; {} taken, {} let pass",
                             fit->median, fit->low, fit->high, fit->taken, fit->left);
  }
  return line_chart(chart);
}

CrossingNumbers numbers_of(std::span<const SeenCrossing> all,
                           const std::optional<GapAcceptance>& fit) {
  CrossingNumbers numbers;
  numbers.all = all.size();
  numbers.gaps = fit;
  for (const SeenCrossing& one : all) {
    numbers.between += one.between ? 1 : 0;
    numbers.waited += one.waited;
    numbers.near += one.near_conflicts;
    numbers.far += one.far_conflicts;
  }
  if (numbers.between > 0) numbers.waited /= static_cast<double>(numbers.between);
  return numbers;
}

std::unique_ptr<Place> place_with_streets(const std::string& scenario,
                                          const SeenCrossingOptions& options) {
  if (scenario.empty()) {
    throw InputError("needs --scenario", {.element = "option --zone", .value = options.zone_file});
  }
  auto place =
      std::make_unique<Place>(read_place(read_any_scenario(scenario, {}), options.zone_file));
  const bool any =
      std::ranges::any_of(place->zones, [](const Zone& zone) { return !zone.streets.empty(); });
  if (any) return place;
  throw InputError("has no street to watch",
                   {.element = "option --zone",
                    .value = options.zone_file,
                    .allowed = "a zone with crossing=\"anywhere\" and streets with ground for "
                               "people on both sides"});
}

}  // namespace

std::string text_of(const CrossingNumbers& numbers) {
  std::string text = fmt::format("Streets were crossed {} times, {} of them between the junctions",
                                 numbers.all, numbers.between);
  if (numbers.between > 0) {
    text +=
        fmt::format(" ({:.0f} %), after {:.1f} s at the kerb",
                    100.0 * static_cast<double>(numbers.between) / static_cast<double>(numbers.all),
                    numbers.waited);
  }
  text += ".\n";
  if (numbers.between > 0) {
    text += fmt::format(
        "Conflicts of these with moving vehicles: {:.0f} on the near half of the "
        "carriageway, seen from the kerb that they come from, {:.0f} on the far one.\n",
        numbers.near, numbers.far);
  }
  if (const auto& fit = numbers.gaps) {
    text += fmt::format(
        "Half of the people take a gap of {:.1f} s [{:.1f}, {:.1f}]: {} gaps were "
        "taken, {} let pass.\n",
        fit->median, fit->low, fit->high, fit->taken, fit->left);
  }
  return text;
}

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

CrossingNumbers SeenCrossings::finish() {
  crossings_.count_conflicts(conflicts_);
  const std::vector<SeenCrossing> all = crossings_.all();
  const std::vector<GapChoice> choices = study::gap_choices(all);
  const std::optional<GapAcceptance> fit = fit_gap_acceptance(choices);
  if (csv_) csv_->write(study::crossings_csv(all));
  if (svg_) svg_->write(chart_of(choices, fit));
  if (csv_) csv_->finish();
  if (svg_) svg_->finish();
  return numbers_of(all, fit);
}

}  // namespace pedzone
