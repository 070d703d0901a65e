// The results of a study: a table of runs, and the models compared in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/plan.hpp"
#include "study/record.hpp"
#include "study/statistics.hpp"

namespace pedzone {

/// Records of a plan's runs, by index of Plan::runs; unset where there is none yet.
using Records = std::vector<std::optional<RunRecord>>;

/// How a comparison comes out.
enum class Finding {
  kDifferent,  ///< corrected p < 0.05
  kNotShown,   ///< no difference shown, and the interval is narrow: half width within 10 % of the
               ///< reference's mean
  kInconclusive,  ///< no difference shown, but the interval is too wide to say anything
  kSame,          ///< the values are equal in every pair
  kTooFew,        ///< fewer than 2 pairs
};

/// A model against the reference, in one condition, by one measure.
struct Comparison {
  std::size_t condition = 0;
  std::string model;
  std::string measure;  ///< key
  SampleSummary reference, sample;
  PairedDifference difference;   ///< model less reference, by seed
  std::optional<double> p_holm;  ///< over the family: all primary ones, or all others
  std::size_t seeds_needed = 0;  ///< for a half width of 5 % of the reference's mean; 0: not known
  Finding finding = Finding::kTooFew;
};

/// All comparisons, by condition, model, measure in their order.
std::vector<Comparison> compare(const Plan& plan, const Records& records);

/// Free speed: a model's over the reference's, in pairs of persons.
struct FreeSpeed {
  std::size_t condition = 0;
  std::string model;
  std::size_t persons = 0;
  double ratio = 1.0;   ///< mean
  bool agrees = false;  ///< within 2 %
};
std::vector<FreeSpeed> free_speeds(const Plan& plan, const Records& records);

/// The tables. CSV with a header; fields of hostile ids are quoted. Contain no clock.
std::string runs_csv(const Plan& plan, const Records& records);
std::string summary_csv(const Plan& plan, const std::vector<Comparison>& comparisons);
std::string summary_json(const Plan& plan, const Records& records,
                         const std::vector<Comparison>& comparisons,
                         const std::vector<FreeSpeed>& speeds);

}  // namespace pedzone
