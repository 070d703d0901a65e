// Statistics of samples and of paired differences. No function divides by a variance of zero.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pedzone::study {

struct Interval {
  double low, high;
};

/// A sample's description. Undefined ones (few values) are unset.
struct SampleSummary {
  std::size_t n = 0;
  std::optional<double> mean, median, sd, min, max, quartile1, quartile3;
};
SampleSummary summarize(std::span<const double> sample);

/// What is said of the differences x_i - y_i of pairs.
struct PairedDifference {
  std::size_t n = 0;                  ///< pairs
  double mean = 0.0, sd = 0.0;        ///< meaningless where n is 0, sd where n < 2
  std::optional<Interval> student;    ///< 95 % of the mean, where n >= 2
  std::optional<Interval> bootstrap;  ///< 95 % of the mean (bootstrap.hpp), where n >= 10
  /// Two-sided paired Student test, where n >= 3. Where the differences do not vary, the sign test
  /// in its place: 2^(1-n), and 1 where all are 0.
  std::optional<double> p;
  /// Cohen's d of the differences with Hedges' correction (1981), where n >= 3; unset where they do
  /// not vary, and 0 where all are 0.
  std::optional<double> effect;
  bool all_equal = false;  ///< n > 0, and the differences do not vary: both intervals are a point
};

/// `differences`: finite. `seed` decides the resamples: the same seed, the same bits, in whatever
/// order the differences come.
PairedDifference compare_pairs(std::span<const double> differences, std::uint64_t seed);

/// Half width of the 95 % interval of the difference of two independent means, by Welch's test
/// (Welch 1947). Both samples with n >= 2 and not both of one value.
double welch_half_width(double sd_a, std::size_t n_a, double sd_b, std::size_t n_b);

/// p-values corrected for their number (Holm 1979), in their order.
std::vector<double> holm(std::span<const double> p);

/// Seeds in all for which the half width of the 95 % interval of a mean is expected to be
/// `half_width` > 0, given the standard deviation of the differences. 2 to a million.
std::size_t seeds_needed(double sd, double half_width);

}  // namespace pedzone::study
