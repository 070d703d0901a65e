#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/statistics.hpp"
#include "results/run_tables.hpp"
#include "study/measure/measure_list.hpp"
#include "study/report/report_parts.hpp"

namespace pedzone::study::report {
namespace {

constexpr std::size_t kMostPoints = 60;         // of runs beside a box; the box has all
constexpr std::size_t kMostChartPoints = 1500;  // of all boxes of a chart
constexpr std::size_t kMostMoments = 150;       // of a line over time
constexpr double kLow = 0.1, kHigh = 0.9;       // what lies between is the band

struct SeedValue {
  double value;
  std::uint64_t seed;
};

/// The sample as a box and points, by value; of many only some, evenly by rank.
Json group(std::vector<SeedValue> sample, std::size_t most) {
  std::ranges::sort(sample, {},
                    [](const SeedValue& one) { return std::pair(one.value, one.seed); });
  std::vector<double> values;
  for (const SeedValue& one : sample) values.push_back(one.value);
  Json box = Json::array();
  for (const double q : {0.0, 0.25, 0.5, 0.75, 1.0}) box.push_back(rounded(quantile(values, q)));
  Json points = Json::array();
  const std::size_t shown = std::min(sample.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t at = shown == 1 ? 0 : i * (sample.size() - 1) / (shown - 1);
    points.push_back({rounded(sample[at].value), sample[at].seed});
  }
  return {{"n", sample.size()}, {"box", box}, {"points", points}};
}

Json distribution(const Input& input, std::string_view key) {
  const Plan& plan = input.plan;
  const std::size_t boxes = pictured(plan) * plan.study.models.size();
  const std::size_t most = std::clamp<std::size_t>(kMostChartPoints / boxes, 2, kMostPoints);
  Json groups = Json::array();
  for (std::size_t c = 0; c < pictured(plan); ++c) {
    for (std::size_t m = 0; m < plan.study.models.size(); ++m) {
      std::vector<SeedValue> sample;
      for (const std::uint64_t seed : plan.study.seeds) {
        const RunRecord* run = done_run(input, c, plan.study.models[m], seed);
        if (run == nullptr) continue;
        if (const auto found = run->measures.find(std::string(key)); found != run->measures.end()) {
          sample.push_back({found->second, seed});
        }
      }
      if (sample.empty()) continue;
      Json one = group(std::move(sample), most);
      one["c"] = c;
      one["m"] = m;
      groups.push_back(std::move(one));
    }
  }
  return groups;
}

// Over time

constexpr std::array kDrawn{&SeriesRow::persons, &SeriesRow::person_speed, &SeriesRow::density,
                            &SeriesRow::vehicles, &SeriesRow::vehicle_speed};
constexpr std::size_t kQuantities = kDrawn.size();

/// Values of all runs by time, for each quantity.
using Moments = std::map<double, std::array<std::vector<double>, kQuantities>>;

void add_series(Moments& moments, const std::string& file) {
  series_table().visit(file, [&](const SeriesRow& row, const CsvRow&) {
    auto& moment = moments[row.time];
    for (std::size_t q = 0; q < kQuantities; ++q) {
      if (const auto& value = row.*kDrawn[q]) moment[q].push_back(*value);
    }
  });
}

/// Neighbouring moments together, so that there are at most so many.
Moments thinned(Moments moments) {
  if (moments.size() <= kMostMoments) return moments;
  const std::size_t every = (moments.size() + kMostMoments - 1) / kMostMoments;
  Moments few;
  std::size_t index = 0;
  auto* into = static_cast<Moments::mapped_type*>(nullptr);
  for (auto& [time, values] : moments) {
    if (index++ % every == 0) into = &few[time];
    for (std::size_t q = 0; q < kQuantities; ++q) {
      (*into)[q].insert((*into)[q].end(), values[q].begin(), values[q].end());
    }
  }
  return few;
}

Json line(const Moments& moments, std::size_t quantity) {
  Json means = Json::array(), low = Json::array(), high = Json::array();
  for (const auto& [time, values] : moments) {
    const std::vector<double>& sample = values[quantity];
    if (sample.empty()) {
      for (Json* one : {&means, &low, &high}) one->push_back(nullptr);
      continue;
    }
    means.push_back(rounded(mean(sample)));
    low.push_back(rounded(quantile(sample, kLow)));
    high.push_back(rounded(quantile(sample, kHigh)));
  }
  return {{"mean", means}, {"low", low}, {"high", high}};
}

Json model_series(const Input& input, std::size_t condition, std::size_t model) {
  Moments moments;
  std::size_t runs = 0;
  for (const std::string& folder : run_folders(input, condition, input.plan.study.models[model])) {
    const std::string file = folder + "/series.csv";
    if (!std::filesystem::exists(file)) continue;
    add_series(moments, file);
    ++runs;
  }
  moments = thinned(std::move(moments));
  Json times = Json::array(), lines = Json::object();
  for (const auto& [time, values] : moments) times.push_back(time);
  const std::vector<std::string>& names = series_table().names();  // the first: the time
  for (std::size_t q = 0; q < kQuantities; ++q) lines[names[q + 1]] = line(moments, q);
  return {{"m", model}, {"runs", runs}, {"times", times}, {"lines", lines}};
}

}  // namespace

double rounded(double value) {
  constexpr int kDigits = 5;
  if (value == 0.0 || !std::isfinite(value)) return 0.0;
  const double scale = std::pow(10.0, kDigits - 1 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

Json distributions(const Input& input) {
  Json all = Json::array();
  for (const Measure& measure : measure_list()) {
    if (!measure.primary) continue;
    Json groups = distribution(input, measure.key);
    if (groups.empty()) continue;
    all.push_back({{"key", std::string(measure.key)},
                   {"label", measure_label(measure)},
                   {"unit", std::string(measure.unit)},
                   {"groups", std::move(groups)}});
  }
  return all;
}

Json series(const Input& input) {
  Json all = Json::array();
  for (std::size_t c = 0; c < pictured(input.plan); ++c) {
    Json models = Json::array();
    for (std::size_t m = 0; m < input.plan.study.models.size(); ++m) {
      Json one = model_series(input, c, m);
      if (!one["times"].empty()) models.push_back(std::move(one));
    }
    all.push_back(std::move(models));
  }
  return all;
}

}  // namespace pedzone::study::report
