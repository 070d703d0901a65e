#include "study/compare/bootstrap.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "core/statistics.hpp"

namespace pedzone::study {
namespace {

constexpr std::size_t kResamples = 2000;  // Efron and Tibshirani 1993, section 14.3: B = 2000
constexpr double kTail = 0.025;           // of a two-sided 95 % interval
constexpr double kSkewDivisor = 6.0;      // Efron and Tibshirani 1993, equation 14.15
/// Numerical: standardised totals closer than this per value differ by rounding only.
constexpr double kRounding = 1e-12;

double normal_share(double z) { return boost::math::cdf(boost::math::normal(), z); }
double normal_quantile(double share) { return boost::math::quantile(boost::math::normal(), share); }

/// Deviations from the mean in standard deviations: resampling these makes the interval move and
/// stretch with the sample.
struct Standardised {
  double mean = 0.0, sd = 0.0;
  std::vector<double> values;

  explicit Standardised(std::span<const double> sample) : values(sample.begin(), sample.end()) {
    mean = pedzone::mean(values);
    sd = standard_deviation(values, mean);
    for (double& value : values) value = (value - mean) / sd;
  }
};

std::vector<double> resampled_totals(const std::vector<double>& values, std::uint64_t seed) {
  std::vector<double> totals(kResamples, 0.0);
  for (std::size_t resample = 0; resample < kResamples; ++resample) {
    for (std::size_t draw = 0; draw < values.size(); ++draw) {
      const std::uint64_t bits = random_bits(seed, resample, draw, Purpose::kBootstrap) >> 32;
      totals[resample] += values[bits * values.size() >> 32];
    }
  }
  return totals;
}

/// The share of totals below the sample's own, 0, as a normal quantile (equation 14.14).
double bias_correction(const std::vector<double>& totals, double rounding) {
  double below = 0.0;
  for (const double total : totals) {
    if (total < -rounding)
      below += 1.0;
    else if (total <= rounding)
      below += 1.0 / 2.0;
  }
  const double least = 1.0 / 2.0;  // none at all would be infinitely far away
  const double most = static_cast<double>(kResamples) - least;
  return normal_quantile(std::clamp(below, least, most) / static_cast<double>(kResamples));
}

double acceleration(const std::vector<double>& values) {
  double squares = 0.0, cubes = 0.0;
  for (const double value : values) {
    squares += value * value;
    cubes += value * value * value;
  }
  return cubes / (kSkewDivisor * squares * std::sqrt(squares));
}

/// The normal quantile whose tail makes the interval of a normal sample as wide as Student's
/// (Hesterberg 2015, expanded percentile interval).
double widened_quantile(std::size_t n) {
  const double freedom = static_cast<double>(n) - 1.0;
  const boost::math::students_t student(freedom);
  return std::sqrt(static_cast<double>(n) / freedom) *
         boost::math::quantile(boost::math::complement(student, kTail));
}

}  // namespace

Interval bootstrap_mean(std::span<const double> sample, std::uint64_t seed) {
  const Standardised standardised(sample);
  const auto n = static_cast<double>(sample.size());
  const std::vector<double> totals = resampled_totals(standardised.values, seed);
  const double bias = bias_correction(totals, n * kRounding);
  const double acceleration_of_sample = acceleration(standardised.values);
  const double width = widened_quantile(sample.size());
  const auto end = [&](double z) {  // equation 14.10
    const double share =
        normal_share(bias + (bias + z) / (1.0 - acceleration_of_sample * (bias + z)));
    const double end_of_mean = standardised.mean + standardised.sd * quantile(totals, share) / n;
    return std::abs(end_of_mean) <= kRounding * n * standardised.sd ? 0.0 : end_of_mean;
  };
  return {end(-width), end(width)};
}

}  // namespace pedzone::study
