// The bootstrap interval against theory that does not resample.
#include "study/compare/bootstrap.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

namespace pedzone::study {
namespace {

/// Quantiles of an exponential distribution: skewed like one, without chance.
std::vector<double> exponential_quantiles(std::size_t n) {
  std::vector<double> sample;
  for (std::size_t i = 0; i < n; ++i) {
    sample.push_back(-std::log((static_cast<double>(i) + 0.5) / static_cast<double>(n)));
  }
  return sample;
}

struct Moments {
  double mean = 0.0, sd = 0.0, skewness = 0.0;
};

Moments moments(const std::vector<double>& sample) {
  Moments m;
  const auto n = static_cast<double>(sample.size());
  for (const double x : sample) m.mean += x / n;
  for (const double x : sample) m.sd += (x - m.mean) * (x - m.mean) / n;
  m.sd = std::sqrt(m.sd);
  for (const double x : sample) m.skewness += std::pow((x - m.mean) / m.sd, 3.0) / n;
  return m;
}

TEST(Bootstrap, has_the_ends_that_Edgeworth_expansion_gives) {
  // To second order the ends are mean + sd / sqrt(n) (z + a (2 z^2 + 1)), a = skewness / (6
  // sqrt(n)): Cornish and Fisher's quantile of resampled means, z + a (z^2 - 1), at BCa's z + a
  // (z^2 + 2) (Hall 1992, The Bootstrap and Edgeworth Expansion, section 3.10).
  const std::vector<double> sample = exponential_quantiles(400);
  const Moments m = moments(sample);
  const double root = std::sqrt(static_cast<double>(sample.size()));
  const double z = 1.959964;
  const double shift = m.skewness / (6.0 * root) * (2.0 * z * z + 1.0);
  EXPECT_GT(shift, 0.12) << "or skewness is not looked at at all";
  // One interval's ends have a standard error of 0.08 by chance of the resamples, the mean of 100
  // of 0.008; what is left out is of the order of 1/n.
  constexpr int kIntervals = 100;
  double low = 0.0, high = 0.0;
  for (int seed = 0; seed < kIntervals; ++seed) {
    const Interval interval = bootstrap_mean(sample, static_cast<std::uint64_t>(seed));
    low += (interval.low - m.mean) / (m.sd / root) / kIntervals;
    high += (interval.high - m.mean) / (m.sd / root) / kIntervals;
  }
  EXPECT_NEAR(low, -z + shift, 0.04);
  EXPECT_NEAR(high, z + shift, 0.04);
}

TEST(Bootstrap, of_a_symmetric_sample_is_about_Students) {
  std::vector<double> sample;
  for (int i = -10; i <= 10; ++i) sample.push_back(i);
  const PairedDifference difference = compare_pairs(sample, 5);
  const double half = difference.student->high;
  EXPECT_NEAR(difference.bootstrap->low, -half, 0.08 * half);
  EXPECT_NEAR(difference.bootstrap->high, half, 0.08 * half);
}

TEST(Bootstrap, of_the_same_seed_has_the_same_bits_and_of_another_others) {
  const std::vector<double> sample = exponential_quantiles(12);
  const Interval one = bootstrap_mean(sample, 1), again = bootstrap_mean(sample, 1);
  EXPECT_EQ(one.low, again.low);
  EXPECT_EQ(one.high, again.high);
  EXPECT_NE(one.low, bootstrap_mean(sample, 2).low);
}

TEST(Bootstrap, stays_finite_when_a_single_value_differs) {
  // As skewed as a sample can be: most resamples miss the one, or all are alike.
  for (const double value : {1.0, -1.0, 1e9}) {
    std::vector<double> sample(kLeastForBootstrap, 0.0);
    sample.front() = value;
    const Interval interval = bootstrap_mean(sample, 1);
    EXPECT_TRUE(std::isfinite(interval.low) && std::isfinite(interval.high));
    EXPECT_LE(interval.low, interval.high);
    const double rounding = 1e-12 * std::abs(value);
    EXPECT_LE(interval.high, std::max(value, 0.0) + rounding);
    EXPECT_GE(interval.low, std::min(value, 0.0) - rounding);
  }
}

}  // namespace
}  // namespace pedzone::study
