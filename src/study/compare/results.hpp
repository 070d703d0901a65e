// The results of a study: a table of runs, and the models compared in it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/table.hpp"
#include "study/compare/statistics.hpp"
#include "study/plan/plan.hpp"
#include "study/run/record.hpp"

namespace pedzone::study {

/// How a comparison comes out.
enum class Finding {
  kDifferent,     ///< corrected p < 0.05
  kHint,          ///< p < 0.05 by itself, but not once it is corrected
  kNotShown,      ///< no difference shown, and Student's interval is narrow: half width within 10 %
                  ///< of the reference's mean
  kInconclusive,  ///< no difference shown, but the interval is too wide to say anything, or the few
                  ///< differences are all the same
  kSame,          ///< the values are equal in every pair
  kTooFew,        ///< fewer than 3 pairs
};

/// As in the tables: different, hint, notShown, inconclusive, same, tooFew.
std::string_view finding_name(Finding finding);

/// What the end of the runs leaves of a difference of times.
enum class Bound {
  kExact,    ///< all of it: as many have arrived with both, to 5 points, and four of five at least
  kAtLeast,  ///< who has fewer arrivals has the longer times, and they would have grown
  kUnknown,  ///< who has fewer arrivals has the shorter times: they may not be shorter; or few
             ///< have arrived with both
};

/// As in the tables: exact, atLeast, unknown.
std::string_view bound_name(Bound bound);

/// A model against the reference, in one condition, by one measure. A seed gives a pair where both
/// runs are done and the measure is defined in both.
struct Comparison {
  std::size_t condition = 0;
  std::string model;
  std::string measure;              ///< key
  SampleSummary reference, sample;  ///< of the pairs
  PairedDifference difference;      ///< model less reference, by seed
  std::optional<double> relative;  ///< mean difference over the size of the reference's mean, where
                                   ///< that is not 0
  std::optional<double> p_holm;    ///< over the family: all primary ones, or all others
  std::size_t missing = 0;         ///< seeds without a pair: a run failed or is not there
  std::size_t undefined = 0;       ///< seeds without a pair: e.g. no conflict, so no TTC
  std::size_t seeds_needed = 0;    ///< in all, for a half width of 5 % of the reference's mean;
                                   ///< 0: not known
  Finding finding = Finding::kTooFew;
  Bound bound = Bound::kExact;
};

/// Sets Comparison::bound of one model's comparisons in one condition.
void mark_cut_off(std::span<Comparison> of_model);

/// Shares of people that have arrived by the end of the runs: more than 5 points apart, or small.
struct CutOff {
  double reference = 0.0, model = 0.0;  ///< means
  bool apart = true;                    ///< by more than 5 points
  std::optional<double> end;            ///< [s] with which nearly all would arrive in every run,
                                        ///< rounded up; unset: in some runs nobody arrives any more
};
/// Unset where they are neither.
std::optional<CutOff> cut_off(std::span<const Comparison> of_model);

/// Fewer pairs make no test: PairedDifference::p is unset.
inline constexpr std::size_t kLeastPairs = 3;

/// All comparisons, by condition, model, measure in their order.
std::vector<Comparison> compare(const Plan& plan, const Records& records);

/// Those of one model in one condition, in their order.
std::vector<Comparison> comparisons_of(std::span<const Comparison> all, std::size_t condition,
                                       const std::string& model);

/// How people walk who meet nobody: a model's over the reference's, in pairs of persons.
struct FreeSpeed {
  std::size_t condition = 0;
  std::string model;
  std::size_t persons = 0;             ///< 0: not measured, and the rest has no meaning
  double ratio = 1.0;                  ///< of speeds, mean
  double lowest = 1.0, highest = 1.0;  ///< of a single person
  bool agrees = false;                 ///< the mean within 2 %
  SampleSummary way = {};              ///< of all ways over the reference's, less 1
  SampleSummary time = {};             ///< of all trips' times over the reference's, less 1
};

/// What is left of a difference when that between people who walk alone is taken off. All in shares
/// of the reference's mean.
struct Interaction {
  double all = 0.0;                  ///< the difference
  double geometry = 0.0;             ///< of people who walk alone: ways, not others
  double interaction = 0.0;          ///< the rest
  std::optional<Interval> interval;  ///< 95 % of the rest, where it varies (Welch)
};
/// `alone`: FreeSpeed::time, of trips' times. Unset where either is not known.
std::optional<Interaction> interaction_of(const Comparison& comparison, const SampleSummary& alone);

std::vector<FreeSpeed> free_speeds(const Plan& plan, const Records& records);

/// Runs that are no fair pair: not the same persons or vehicles were to travel at the same times.
struct UnequalDemand {
  std::size_t condition = 0;
  std::string model;
  std::string what;                  ///< key of RunRecord::demand
  std::vector<std::uint64_t> seeds;  ///< where it differs from the reference's
};
std::vector<UnequalDemand> unequal_demands(const Plan& plan, const Records& records);

/// The tables. CSV with a header; fields of hostile ids are quoted. Contain no clock.
/// Factors have columns `factor.ID`, so that no id can be taken for another column.
inline constexpr const char* kFactorColumn = "factor.";
std::string runs_csv(const Plan& plan, const Records& records);
std::string summary_csv(const Plan& plan, const std::vector<Comparison>& comparisons);
/// Their columns where nothing varies. Those of factors are texts.
std::vector<ColumnInfo> runs_columns();
std::vector<ColumnInfo> summary_columns();
/// Also the set-up, how fair the pairs are, and the runs that failed.
std::string summary_json(const Plan& plan, const Records& records,
                         const std::vector<Comparison>& comparisons,
                         const std::vector<FreeSpeed>& speeds);

}  // namespace pedzone::study
