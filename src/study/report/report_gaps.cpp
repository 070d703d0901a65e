// Gaps between vehicles that people take who cross streets anywhere: those of all seeds together.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "conflict/gap_acceptance.hpp"
#include "study/measure/run_measures.hpp"
#include "study/measure/street_crossings.hpp"
#include "study/report/report_numbers.hpp"
#include "study/report/report_parts.hpp"

namespace pedzone::study::report {
namespace {

constexpr double kCurveStep = 0.5;  // [s] between points of a curve
constexpr int kDecimals = 1;        // of gaps in the table [s]

std::vector<GapChoice> choices_of(const Input& input, std::size_t condition,
                                  const std::string& model) {
  std::vector<SeenCrossing> crossings;
  for (const std::string& folder : run_folders(input, condition, model)) {
    const std::string file = folder + "/" + kCrossings;
    if (!std::filesystem::exists(file)) continue;
    seen_crossing_table().visit(
        file, [&](const SeenCrossing& row, const CsvRow&) { crossings.push_back(row); });
  }
  return gap_choices(crossings);
}

Json curve_of(const GapAcceptance& fit) {
  Json points = Json::array();
  for (double gap = 0.0; gap <= kLongestGap; gap += kCurveStep) {
    points.push_back({gap, rounded(fit.share(gap))});
  }
  return points;
}

/// Where one gap parts those taken from the others there is no curve, nor an interval.
Json group(std::span<const GapChoice> choices) {
  const auto taken = static_cast<std::size_t>(std::ranges::count(choices, true, &GapChoice::taken));
  Json one{{"taken", taken}, {"left", choices.size() - taken}};
  for (const auto& [gap, share, gaps] : shares_taken(choices)) {
    one["counted"].push_back({gap, rounded(share), gaps});
  }
  if (const auto fit = fit_gap_acceptance(choices)) {
    one["median"] = rounded(fit->median);
    if (std::isfinite(fit->slope)) {
      one["interval"] = {rounded(fit->low), rounded(fit->high)};
      one["curve"] = curve_of(*fit);
    }
  }
  return one;
}

std::string median_text(const Json& group) {
  if (!group.contains("median")) return digits_text({});
  std::string text = number_text(group["median"], kDecimals);
  if (!group.contains("interval")) return text;
  return text + " [" + number_text(group["interval"][0], kDecimals) + ", " +
         number_text(group["interval"][1], kDecimals) + "]";
}

}  // namespace

Json gaps(const Input& input) {
  Json groups = Json::array();
  for (std::size_t c = 0; c < pictured(input.plan); ++c) {
    for (std::size_t m = 0; m < input.plan.study.models.size(); ++m) {
      const auto choices = choices_of(input, c, input.plan.study.models[m]);
      if (choices.empty()) continue;
      Json one = group(choices);
      one["c"] = c;
      one["m"] = m;
      groups.push_back(std::move(one));
    }
  }
  return groups;
}

Json gaps_part(const Input& input, const Json& groups) {
  if (groups.empty()) return false;
  Json rows = Json::array();
  for (const Json& one : groups) {
    rows.push_back({{"condition", input.plan.conditions[one["c"]].name},
                    {"model", input.plan.study.models[one["m"]]},
                    {"median", median_text(one)},
                    {"taken", one["taken"]},
                    {"left", one["left"]}});
  }
  return {{"rows", rows}};
}

}  // namespace pedzone::study::report
