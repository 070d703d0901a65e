// Models against the reference, measure by measure, in pairs of one seed.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/random.hpp"
#include "study/compare/measured.hpp"
#include "study/compare/results.hpp"
#include "study/measure/measure_list.hpp"

namespace pedzone::study {
namespace {

constexpr double kLevel = 0.05;            // of significance, usual
constexpr double kNarrow = 0.1;            // assumed: half width over the reference's mean
constexpr double kWantedPrecision = 0.05;  // assumed: the same, for the seeds needed
/// Numerical: values closer than this share of theirs are equal but for rounding.
constexpr double kRounding = 1e-12;

struct Pairs {
  std::vector<double> reference, model, differences;
  std::size_t missing = 0, undefined = 0;
};

/// Indices into Plan::runs of a condition's runs with a model, by seed.
std::vector<std::size_t> runs_of(const Plan& plan, std::size_t condition,
                                 const std::string& model) {
  std::vector<std::size_t> runs;
  for (const std::uint64_t seed : plan.study.seeds) {
    runs.push_back(plan.run_of(RunKind::kStudy, condition, model, seed));
  }
  return runs;
}

double difference_of(double model, double reference) {
  const double difference = model - reference;
  const double greater = std::max(std::abs(model), std::abs(reference));
  return std::abs(difference) <= kRounding * greater ? 0.0 : difference;
}

Pairs collect_pairs(const Records& records, const std::vector<std::size_t>& reference_runs,
                    const std::vector<std::size_t>& model_runs, const std::string& key) {
  Pairs pairs;
  for (std::size_t seed = 0; seed < reference_runs.size(); ++seed) {
    const auto& reference_record = records[reference_runs[seed]];
    const auto& model_record = records[model_runs[seed]];
    if (!is_done(reference_record) || !is_done(model_record)) {
      ++pairs.missing;
      continue;
    }
    const auto reference = measured(reference_record, key);
    const auto model = measured(model_record, key);
    if (!reference || !model) {
      ++pairs.undefined;
      continue;
    }
    pairs.reference.push_back(*reference);
    pairs.model.push_back(*model);
    pairs.differences.push_back(difference_of(*model, *reference));
  }
  return pairs;
}

/// All but what the family of tests decides.
Comparison compare_pairs_of(const Plan& plan, std::size_t condition, const std::string& model,
                            const Pairs& pairs, const std::string& key) {
  Comparison comparison;
  comparison.condition = condition;
  comparison.model = model;
  comparison.measure = key;
  comparison.missing = pairs.missing;
  comparison.undefined = pairs.undefined;
  comparison.reference = summarize(pairs.reference);
  comparison.sample = summarize(pairs.model);
  // The resamples of one comparison are the same in whatever study it stands.
  const std::string name = plan.conditions[condition].name + '\n' + model + '\n' + key;
  comparison.difference = compare_pairs(pairs.differences, person_key(name));
  const double scale = std::abs(comparison.reference.mean.value_or(0.0));
  if (scale > 0.0) comparison.relative = comparison.difference.mean / scale;
  if (scale > 0.0 && comparison.difference.n >= 2) {
    comparison.seeds_needed = seeds_needed(comparison.difference.sd, kWantedPrecision * scale);
  }
  return comparison;
}

Finding finding_of(const Comparison& comparison) {
  const PairedDifference& difference = comparison.difference;
  if (difference.n < kLeastPairs) return Finding::kTooFew;
  if (difference.all_equal && difference.mean == 0.0) return Finding::kSame;
  if (*comparison.p_holm < kLevel) return Finding::kDifferent;
  if (*difference.p < kLevel) return Finding::kHint;
  const double half_width = (difference.student->high - difference.student->low) / 2.0;
  const double scale = std::abs(*comparison.reference.mean);
  const bool narrow = !difference.all_equal && half_width <= kNarrow * scale;
  return narrow ? Finding::kNotShown : Finding::kInconclusive;
}

void correct_family(std::vector<Comparison>& comparisons, bool primary) {
  std::vector<Comparison*> family;
  std::vector<double> p;
  for (Comparison& comparison : comparisons) {
    if (find_measure(comparison.measure)->primary != primary || !comparison.difference.p) continue;
    family.push_back(&comparison);
    p.push_back(*comparison.difference.p);
  }
  const std::vector<double> corrected = holm(p);
  for (std::size_t i = 0; i < family.size(); ++i) family[i]->p_holm = corrected[i];
}

}  // namespace

std::string_view finding_name(Finding finding) {
  switch (finding) {
    case Finding::kDifferent:
      return "different";
    case Finding::kHint:
      return "hint";
    case Finding::kNotShown:
      return "notShown";
    case Finding::kInconclusive:
      return "inconclusive";
    case Finding::kSame:
      return "same";
    case Finding::kTooFew:
      break;
  }
  return "tooFew";
}

std::string_view bound_name(Bound bound) {
  switch (bound) {
    case Bound::kAtLeast:
      return "atLeast";
    case Bound::kUnknown:
      return "unknown";
    case Bound::kExact:
      break;
  }
  return "exact";
}

std::vector<Comparison> compare(const Plan& plan, const Records& records) {
  std::vector<Comparison> comparisons;
  for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
    const auto reference_runs = runs_of(plan, condition, plan.study.reference);
    for (const std::string& model : plan.study.models) {
      if (model == plan.study.reference) continue;
      const auto model_runs = runs_of(plan, condition, model);
      const std::size_t first = comparisons.size();
      for (const Measure& measure : measure_list()) {
        const std::string key(measure.key);
        const Pairs pairs = collect_pairs(records, reference_runs, model_runs, key);
        if (measure.optional && pairs.undefined > 0 && pairs.differences.empty()) continue;
        comparisons.push_back(compare_pairs_of(plan, condition, model, pairs, key));
      }
      mark_cut_off(std::span(comparisons).subspan(first));
    }
  }
  correct_family(comparisons, true);
  correct_family(comparisons, false);
  for (Comparison& comparison : comparisons) {
    comparison.finding = finding_of(comparison);
    const bool no_difference =
        comparison.finding == Finding::kSame || comparison.finding == Finding::kNotShown;
    // What is cut off would have gone on to differ.
    if (no_difference && comparison.bound == Bound::kAtLeast) comparison.bound = Bound::kUnknown;
  }
  return comparisons;
}

std::vector<Comparison> comparisons_of(std::span<const Comparison> all, std::size_t condition,
                                       const std::string& model) {
  std::vector<Comparison> found;
  std::ranges::copy_if(all, std::back_inserter(found), [&](const Comparison& one) {
    return one.condition == condition && one.model == model;
  });
  return found;
}

}  // namespace pedzone::study
