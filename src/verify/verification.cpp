#include "verify/verification.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/error.hpp"
#include "core/statistics.hpp"
#include "core/text.hpp"
#include "crowd/state/parallel.hpp"
#include "verify/references.hpp"

namespace pedzone::verify {
namespace {

std::vector<StandardTest> chosen_tests(const std::vector<std::string>& only) {
  std::vector<StandardTest> all = standard_tests();
  if (only.empty()) return all;
  for (const std::string& id : only) {
    if (std::ranges::any_of(all, [&](const StandardTest& test) { return test.id == id; })) continue;
    throw InputError("is no standard test",
                     {"", 0, "option --only", id, comma_list(all, &StandardTest::id)});
  }
  std::erase_if(all, [&](const StandardTest& test) {
    return std::ranges::find(only, test.id) == only.end();
  });
  return all;
}

/// One run that depends on no other.
struct Unit {
  std::size_t test, model, seed, index;
};

void append(Outcome& all, const Outcome& more) {
  all.figures.insert(more.figures.begin(), more.figures.end());
  for (const auto& [key, points] : more.curves) {
    Points& curve = all.curves[key];
    curve.insert(curve.end(), points.begin(), points.end());
  }
  if (more.map) all.map = more.map;
}

bool within(const FigureSpec& spec, double value) {
  if (spec.judged == Judged::kNot) return true;
  if (std::isnan(value)) return false;
  return (!spec.least || value >= *spec.least) && (!spec.most || value <= *spec.most);
}

double figure_of(const Outcome& outcome, const std::string& key) {
  const auto found = outcome.figures.find(key);
  return found == outcome.figures.end() ? std::nan("") : found->second;
}

FigureResult figure_result(const FigureSpec& spec, const std::vector<Outcome>& seeds,
                           double of_medians) {
  std::vector<double> values;
  for (const Outcome& seed : seeds) values.push_back(figure_of(seed, spec.key));
  FigureResult result;
  result.least = *std::ranges::min_element(values);
  result.most = *std::ranges::max_element(values);
  result.value = of_medians;
  if (spec.judged == Judged::kWorst) result.value = spec.most ? result.most : result.least;
  result.passed = within(spec, result.value);
  return result;
}

/// Every figure's median over seeds, and what the test concludes from those.
Outcome median_outcome(const StandardTest& test, const std::vector<Outcome>& seeds) {
  Outcome medians;
  for (const auto& [key, value] : seeds.front().figures) {
    std::vector<double> values;
    for (const Outcome& seed : seeds) values.push_back(figure_of(seed, key));
    medians.figures[key] = median(values);
  }
  if (test.conclude) test.conclude(medians);
  return medians;
}

std::vector<ChartPoint> curve_of(const std::string& key, const std::vector<Outcome>& seeds) {
  std::vector<ChartPoint> curve;
  const auto first = seeds.front().curves.find(key);
  if (first == seeds.front().curves.end()) return curve;
  for (std::size_t k = 0; k < first->second.size(); ++k) {
    std::vector<double> x, y;
    for (const Outcome& seed : seeds) {
      const Points& points = seed.curves.at(key);
      if (k >= points.size()) continue;
      x.push_back(points[k].x);
      y.push_back(points[k].y);
    }
    curve.push_back(
        {median(x), median(y), *std::ranges::min_element(y), *std::ranges::max_element(y)});
  }
  return curve;
}

}  // namespace

bool Verification::passes(std::size_t model) const {
  return std::ranges::all_of(results, [&](const auto& test) { return test[model].passed; });
}

TestResult judged(const StandardTest& test, std::vector<Outcome> seeds) {
  TestResult result;
  const Outcome medians = median_outcome(test, seeds);
  if (test.conclude) std::ranges::for_each(seeds, test.conclude);
  for (const FigureSpec& spec : test.figures) {
    result.figures.push_back(figure_result(spec, seeds, figure_of(medians, spec.key)));
    result.passed = result.passed && result.figures.back().passed;
  }
  for (const ChartSpec& chart : test.charts) result.curves.push_back(curve_of(chart.key, seeds));
  result.map = seeds.front().map;
  return result;
}

Verification verify(const VerifyOptions& options, const std::function<void(double)>& progress) {
  Verification verification{options.models, options.seeds, chosen_tests(options.only), {}};
  for (const std::string& model : options.models) check_model(model);
  const auto seeds = static_cast<std::size_t>(options.seeds);
  std::vector<Unit> units;
  for (std::size_t test = 0; test < verification.tests.size(); ++test) {
    for (std::size_t model = 0; model < options.models.size(); ++model) {
      for (std::size_t seed = 0; seed < seeds; ++seed) {
        for (std::size_t k = 0; k < verification.tests[test].cases; ++k) {
          units.push_back({test, model, seed, k});
        }
      }
    }
  }
  std::vector<Outcome> outcomes(units.size());
  std::atomic<std::size_t> done = 0;
  for_each_parallel(units.size(), [&](std::size_t u) {
    const Unit& unit = units[u];
    const RunInput input{options.models[unit.model], unit.seed + 1};
    outcomes[u] = verification.tests[unit.test].run(input, unit.index);
    if (progress) progress(static_cast<double>(++done) / static_cast<double>(units.size()));
  });
  std::size_t next = 0;
  for (const StandardTest& test : verification.tests) {
    std::vector<TestResult> row;
    for (std::size_t model = 0; model < options.models.size(); ++model) {
      std::vector<Outcome> by_seed(seeds);
      for (Outcome& seed : by_seed) {
        for (std::size_t k = 0; k < test.cases; ++k) append(seed, outcomes[next++]);
      }
      row.push_back(judged(test, std::move(by_seed)));
    }
    verification.results.push_back(std::move(row));
  }
  return verification;
}

}  // namespace pedzone::verify
