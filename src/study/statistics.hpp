// Statistics of samples and of paired differences. No function divides by a variance of zero.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pedzone {

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
  std::optional<Interval> bootstrap;  ///< 95 % of the mean, bias-corrected and accelerated (Efron
                                      ///< 1987), 2,000 resamples, where n >= 5
  std::optional<double> p;       ///< two-sided paired Student test; 1 where all differences are 0
  std::optional<double> effect;  ///< Cohen's d of the differences with Hedges' correction;
                                 ///< unset where they do not vary (and are not all 0)
  bool all_equal = false;        ///< the differences do not vary
};

/// `seed` decides the resamples: the same seed, the same bits.
PairedDifference compare_pairs(std::span<const double> differences, std::uint64_t seed);

/// p-values corrected for their number (Holm 1979), in their order.
std::vector<double> holm(std::span<const double> p);

/// Seeds in all for which the half width of the 95 % interval of a mean is expected to be
/// `half_width` > 0, given the standard deviation of the differences. At least 2.
std::size_t seeds_needed(double sd, double half_width);

}  // namespace pedzone
