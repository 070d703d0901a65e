// Cumulative curves: which share of the persons had no more than a value.
#include <algorithm>
#include <cmath>

#include "core/statistics.hpp"
#include "validation/page_parts.hpp"
#include "view/axis.hpp"

namespace pedzone::page {
namespace {

struct Measure {
  std::string_view title, unit;
  double Measures::*value;
};
constexpr std::array<Measure, 4> kMeasures{{{"smallest clearance", "m", &Measures::clearance},
                                            {"lateral deviation", "m", &Measures::deviation},
                                            {"least speed", "m/s", &Measures::least_speed},
                                            {"mean speed", "m/s", &Measures::mean_speed}}};

constexpr double kShownPart = 0.98;  // of every curve lies left of the axis's end
constexpr double kPerUnit = 1e4;     // numerical: digits that no picture can show are left out

/// One measure of persons; those of several seeds one after the other.
struct Sample {
  std::vector<double> recorded, walked;
  double ks = 0.0;  ///< mean over seeds
};

Sample sample_of(const ValidationResult& result, std::size_t model, PersonSet set,
                 const std::string& group, double Measures::*value) {
  Sample sample;
  const ScoredRuns& runs = result.runs[model];
  std::vector<double> ks;
  for (std::size_t seed = 0; seed < runs.size(); ++seed) {
    std::vector<double> recorded, walked;
    for (const ScoredPerson* person : members(result, runs, seed, set, group)) {
      recorded.push_back(person->recorded.*value);
      walked.push_back(person->walked.*value);
    }
    ks.push_back(ks_distance(recorded, walked));
    sample.walked.insert(sample.walked.end(), walked.begin(), walked.end());
    if (seed == 0) sample.recorded = std::move(recorded);
  }
  sample.ks = mean(ks);
  return sample;
}

/// Where its curve steps up, ascending; what is beyond the axis's end or no number lies there.
Json steps(std::vector<double> values, double end) {
  for (double& value : values) {
    value = std::isnan(value) ? end : std::clamp(value, 0.0, end);
    value = std::round(value * kPerUnit) / kPerUnit;
  }
  std::ranges::sort(values);
  return values;
}

/// Of an axis for all groups of the set.
double end_of(const ValidationResult& result, PersonSet set, const Measure& measure) {
  double most = 0.0;
  for (const std::size_t m : curve_models(result)) {
    const Sample sample = sample_of(result, m, set, "all", measure.value);
    for (const auto* values : {&sample.recorded, &sample.walked}) {
      const double high = quantile(*values, kShownPart);
      if (std::isfinite(high)) most = std::max(most, high);
    }
  }
  const double step = round_step(most, 5.0);
  return step * std::max(1.0, std::ceil(most / step));
}

Json chart(const ValidationResult& result, PersonSet set, const std::string& group,
           const Measure& measure, double end) {
  Json recorded = Json::array(), walked = Json::array(), ks = Json::array();
  for (const std::size_t m : curve_models(result)) {
    Sample sample = sample_of(result, m, set, group, measure.value);
    recorded = steps(std::move(sample.recorded), end);
    walked.push_back(steps(std::move(sample.walked), end));
    ks.push_back(number(sample.ks, 2));
  }
  return {{"recorded", recorded}, {"walked", walked}, {"ks", ks}};
}

}  // namespace

Json curve_measures() {
  Json measures = Json::array();
  for (const Measure& measure : kMeasures) {
    measures.push_back({{"title", measure.title}, {"unit", measure.unit}});
  }
  return measures;
}

std::vector<std::size_t> curve_models(const ValidationResult& result) {
  if (result.models.empty()) return {};
  std::vector<std::size_t> models;
  const std::size_t main = result.models.size() - 1;
  for (const std::string_view name : {"straight to goal", "plain"}) {
    const auto found = std::find(result.models.begin(), result.models.begin() + main, name);
    const auto m = static_cast<std::size_t>(found - result.models.begin());
    if (m < main) models.push_back(m);
  }
  models.push_back(main);
  return models;
}

Json curve_set(const ValidationResult& result, PersonSet set) {
  std::array<double, kMeasures.size()> ends{};
  std::ranges::transform(kMeasures, ends.begin(),
                         [&](const Measure& measure) { return end_of(result, set, measure); });
  Json groups = Json::array();
  for (const std::string& group : shown_groups(result, set)) {
    Json charts = Json::array();
    for (std::size_t k = 0; k < kMeasures.size(); ++k) {
      charts.push_back(chart(result, set, group, kMeasures[k], ends[k]));
    }
    groups.push_back(std::move(charts));
  }
  return {{"ends", ends}, {"groups", groups}};
}

}  // namespace pedzone::page
