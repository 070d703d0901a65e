// Whether the runs of a pair are comparable at all: free speeds and demand.
#include <algorithm>
#include <cmath>
#include <set>

#include "study/compare/measured.hpp"
#include "study/compare/results.hpp"

namespace pedzone::study {
namespace {

constexpr double kAgreement = 0.02;  // project's requirement on a model's free speed

/// Of those whom both walked and `what` is known of: model and reference.
std::vector<std::pair<double, double>> both(const RunRecord& reference, const RunRecord& model,
                                            std::string_view what) {
  std::vector<std::pair<double, double>> all;
  for (const auto& [key, value] : model.measures) {
    if (!key.starts_with(what)) continue;
    const auto found = reference.measures.find(key);
    if (found == reference.measures.end() || !(found->second > 0.0)) continue;
    if (std::isfinite(value)) all.emplace_back(value, found->second);
  }
  return all;
}

SampleSummary ratios(const RunRecord& reference, const RunRecord& model, std::string_view what) {
  std::vector<double> all;
  for (const auto& [own, other] : both(reference, model, what)) all.push_back(own / other);
  return summarize(all);
}

/// By which the sum is larger than the reference's, as a share of that. The standard deviation is
/// that of the ratio of two sums, linearized (W. G. Cochran, Sampling Techniques, 1977, chapter 2).
SampleSummary excess(const RunRecord& reference, const RunRecord& model, std::string_view what) {
  const auto pairs = both(reference, model, what);
  double sum = 0.0, reference_sum = 0.0;
  for (const auto& [own, other] : pairs) {
    sum += own;
    reference_sum += other;
  }
  const double ratio = sum / reference_sum;
  const double mean = reference_sum / static_cast<double>(pairs.size());
  std::vector<double> all;
  for (const auto& [own, other] : pairs) {
    all.push_back(ratio - 1.0 + (own - ratio * other) / mean);
  }
  return summarize(all);
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
  const SampleSummary summary = ratios(*reference_record, *model_record, "speed:");
  speed.persons = summary.n;
  if (summary.n == 0) return speed;
  speed.ratio = *summary.mean;
  speed.lowest = *summary.min;
  speed.highest = *summary.max;
  speed.agrees = std::abs(speed.ratio - 1.0) <= kAgreement;
  speed.way = excess(*reference_record, *model_record, "way:");
  speed.time = excess(*reference_record, *model_record, "time:");
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

std::optional<Interaction> interaction_of(const Comparison& comparison,
                                          const SampleSummary& alone) {
  const PairedDifference& difference = comparison.difference;
  if (!comparison.relative || !alone.mean) return {};
  Interaction parts{*comparison.relative, *alone.mean, *comparison.relative - *alone.mean, {}};
  const double sd = difference.sd / std::abs(*comparison.reference.mean);
  if (difference.n >= 2 && alone.n >= 2 && (sd > 0.0 || *alone.sd > 0.0)) {
    const double half = welch_half_width(sd, difference.n, *alone.sd, alone.n);
    parts.interval = Interval{parts.interaction - half, parts.interaction + half};
  }
  return parts;
}

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
