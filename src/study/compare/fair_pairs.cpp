// Whether the runs of a pair are comparable at all: free speeds and demand.
#include <algorithm>
#include <cmath>
#include <set>

#include "study/compare/measured.hpp"
#include "study/compare/results.hpp"

namespace pedzone::study {
namespace {

constexpr double kAgreement = 0.02;  // project's requirement on a model's free speed

/// A model's speed over the reference's, of those whom both walked.
std::vector<double> ratios(const RunRecord& reference, const RunRecord& model) {
  std::vector<double> all;
  for (const auto& [person, speed] : model.measures) {
    const auto found = reference.measures.find(person);
    if (found == reference.measures.end() || !(found->second > 0.0)) continue;
    if (std::isfinite(speed)) all.push_back(speed / found->second);
  }
  return all;
}

FreeSpeed free_speed(const Plan& plan, const Records& records, std::size_t condition,
                     const std::string& model) {
  const auto record_of = [&](const std::string& name) -> const std::optional<RunRecord>& {
    return records[plan.run_of(RunKind::kFreeSpeed, condition, name, plan.study.seeds.front())];
  };
  FreeSpeed speed;
  speed.condition = condition;
  speed.model = model;
  const auto& reference_record = record_of(plan.study.reference);
  const auto& model_record = record_of(model);
  if (!is_done(reference_record) || !is_done(model_record)) return speed;
  const SampleSummary summary = summarize(ratios(*reference_record, *model_record));
  speed.persons = summary.n;
  if (summary.n == 0) return speed;
  speed.ratio = *summary.mean;
  speed.lowest = *summary.min;
  speed.highest = *summary.max;
  speed.agrees = std::abs(speed.ratio - 1.0) <= kAgreement;
  return speed;
}

/// Keys of demand that differ between two runs.
std::set<std::string> unequal_keys(const RunRecord& reference, const RunRecord& model) {
  std::set<std::string> keys;
  const auto add_unequal = [&](const RunRecord& one, const RunRecord& other) {
    for (const auto& [key, signature] : one.demand) {
      const auto found = other.demand.find(key);
      if (found == other.demand.end() || found->second != signature) keys.insert(key);
    }
  };
  add_unequal(reference, model);
  add_unequal(model, reference);
  return keys;
}

/// A condition's seeds with unequal demand, by key.
std::map<std::string, std::vector<std::uint64_t>> unequal_seeds(const Plan& plan,
                                                                const Records& records,
                                                                std::size_t condition,
                                                                const std::string& model) {
  std::map<std::string, std::vector<std::uint64_t>> unequal;
  for (const std::uint64_t seed : plan.study.seeds) {
    const auto& reference_record =
        records[plan.run_of(RunKind::kStudy, condition, plan.study.reference, seed)];
    const auto& model_record = records[plan.run_of(RunKind::kStudy, condition, model, seed)];
    if (!is_done(reference_record) || !is_done(model_record)) continue;
    for (const std::string& key : unequal_keys(*reference_record, *model_record)) {
      unequal[key].push_back(seed);
    }
  }
  return unequal;
}

}  // namespace

std::vector<FreeSpeed> free_speeds(const Plan& plan, const Records& records) {
  std::vector<FreeSpeed> speeds;
  for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
    for (const std::string& model : plan.study.models) {
      if (model == plan.study.reference) continue;
      speeds.push_back(free_speed(plan, records, condition, model));
    }
  }
  return speeds;
}

std::vector<UnequalDemand> unequal_demands(const Plan& plan, const Records& records) {
  std::vector<UnequalDemand> all;
  for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
    for (const std::string& model : plan.study.models) {
      if (model == plan.study.reference) continue;
      for (auto& [what, seeds] : unequal_seeds(plan, records, condition, model)) {
        all.push_back({condition, model, what, std::move(seeds)});
      }
    }
  }
  return all;
}

}  // namespace pedzone::study
