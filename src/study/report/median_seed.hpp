// Which of many runs to show: the one in the middle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/compare/results.hpp"

namespace pedzone::study {

/// The row that lies closest to the middle of a table, all columns together: the least sum, over
/// columns, of how far the value's rank is from the middle rank; equal values share their mean
/// rank. The first of those that are equally close. `rows`: not empty, of equal lengths.
std::size_t middle_row(const std::vector<std::vector<double>>& rows);

/// The condition in the middle of a scenario's, by the mean number of persons who departed in the
/// reference's runs (of an even number the upper of the two); unset where none has a run.
std::optional<std::size_t> middle_condition(const Plan& plan, const Records& records,
                                            std::size_t scenario);

/// The pair of runs, reference and model, of the median seed: that whose row of paired differences
/// in the primary measures is the middle one.
struct MedianPair {
  std::size_t reference = 0, model = 0;  ///< indices of Plan::runs
  std::uint64_t seed = 0;
  std::size_t seeds = 0;              ///< of how many
  std::vector<std::string> measures;  ///< keys: the primary ones that all pairs have
};
/// Unset where no seed has both runs done.
std::optional<MedianPair> median_pair(const Plan& plan, const Records& records,
                                      std::size_t condition, const std::string& model);

}  // namespace pedzone::study
