#include "study/report/median_seed.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "study/measure/measure_list.hpp"

namespace pedzone::study {
namespace {

/// How far each value's rank is from the middle rank.
std::vector<double> off_middle(const std::vector<double>& values) {
  const double middle = static_cast<double>(values.size() - 1) / 2.0;
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  std::vector<double> result;
  for (const double value : values) {
    const auto [first, last] = std::ranges::equal_range(sorted, value);
    const auto below = static_cast<double>(first - sorted.begin());
    const auto equal = static_cast<double>(last - first);
    result.push_back(std::abs(below + (equal - 1.0) / 2.0 - middle));
  }
  return result;
}

const RunRecord* done(const Records& records, std::size_t run) {
  const std::optional<RunRecord>& record = records[run];
  return record && record->status == RunStatus::kDone ? &*record : nullptr;
}

/// The two runs of a seed, both done.
struct Pair {
  MedianPair runs;
  const RunRecord *reference, *model;
};

std::vector<Pair> pairs_of(const Plan& plan, const Records& records, std::size_t condition,
                           const std::string& model) {
  std::vector<Pair> pairs;
  for (const std::uint64_t seed : plan.study.seeds) {
    const MedianPair runs{plan.run_of(RunKind::kStudy, condition, plan.study.reference, seed),
                          plan.run_of(RunKind::kStudy, condition, model, seed),
                          seed,
                          0,
                          {}};
    const RunRecord *reference = done(records, runs.reference), *other = done(records, runs.model);
    if (reference != nullptr && other != nullptr) pairs.push_back({runs, reference, other});
  }
  return pairs;
}

std::vector<std::string> measures_of_all(const std::vector<Pair>& pairs) {
  std::vector<std::string> keys;
  for (const Measure& measure : measure_list()) {
    const std::string key(measure.key);
    const bool everywhere = std::ranges::all_of(pairs, [&](const Pair& pair) {
      return pair.reference->measures.contains(key) && pair.model->measures.contains(key);
    });
    if (measure.primary && everywhere) keys.push_back(key);
  }
  return keys;
}

}  // namespace

std::size_t middle_row(const std::vector<std::vector<double>>& rows) {
  std::vector<double> off(rows.size(), 0.0);
  for (std::size_t column = 0; column < rows.front().size(); ++column) {
    std::vector<double> values;
    for (const std::vector<double>& row : rows) values.push_back(row[column]);
    const std::vector<double> here = off_middle(values);
    std::ranges::transform(off, here, off.begin(), std::plus());
  }
  return static_cast<std::size_t>(std::ranges::min_element(off) - off.begin());
}

std::optional<std::size_t> middle_condition(const Plan& plan, const Records& records,
                                            std::size_t scenario) {
  struct Crowded {
    double persons;
    std::size_t condition;
  };
  std::vector<Crowded> conditions;
  for (std::size_t c = 0; c < plan.conditions.size(); ++c) {
    if (plan.conditions[c].scenario != scenario) continue;
    double sum = 0.0, runs = 0.0;
    for (const std::uint64_t seed : plan.study.seeds) {
      const std::size_t run = plan.run_of(RunKind::kStudy, c, plan.study.reference, seed);
      const RunRecord* record = done(records, run);
      if (record == nullptr || !record->measures.contains("person.count")) continue;
      sum += record->measures.at("person.count");
      ++runs;
    }
    if (runs > 0.0) conditions.push_back({sum / runs, c});
  }
  if (conditions.empty()) return std::nullopt;
  std::ranges::stable_sort(conditions, {}, &Crowded::persons);
  return conditions[conditions.size() / 2].condition;
}

std::optional<MedianPair> median_pair(const Plan& plan, const Records& records,
                                      std::size_t condition, const std::string& model) {
  const std::vector<Pair> pairs = pairs_of(plan, records, condition, model);
  if (pairs.empty()) return std::nullopt;
  const std::vector<std::string> keys = measures_of_all(pairs);
  std::vector<std::vector<double>> rows;
  for (const Pair& pair : pairs) {
    std::vector<double>& row = rows.emplace_back();
    for (const std::string& key : keys) {
      row.push_back(pair.model->measures.at(key) - pair.reference->measures.at(key));
    }
  }
  MedianPair chosen = pairs[middle_row(rows)].runs;
  chosen.seeds = pairs.size();
  chosen.measures = keys;
  return chosen;
}

}  // namespace pedzone::study
