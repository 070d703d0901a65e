#include "study/compare/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numeric>

#include "core/statistics.hpp"
#include "study/compare/bootstrap.hpp"

namespace pedzone::study {
namespace {

constexpr double kTail = 0.025;  // of a two-sided 95 % interval
constexpr double kQuarter = 0.25;
constexpr std::size_t kLeastForTest = 3;  // with 2, Hedges' correction is 0: no effect size
constexpr std::size_t kFewestSeeds = 2;
constexpr std::size_t kMostSeeds = 1'000'000;  // more is "not to be had"
/// Numerical: differences that vary by less than this share of themselves vary by rounding only.
constexpr double kRounding = 1e-9;

/// Half width of the 95 % interval of the mean.
double student_half_width(double sd, std::size_t n) {
  const boost::math::students_t student(static_cast<double>(n) - 1.0);
  return boost::math::quantile(boost::math::complement(student, kTail)) * sd /
         std::sqrt(static_cast<double>(n));
}

double student_p(double mean, double sd, std::size_t n) {
  const boost::math::students_t student(static_cast<double>(n) - 1.0);
  const double t = std::abs(mean) / (sd / std::sqrt(static_cast<double>(n)));
  return 2.0 * boost::math::cdf(boost::math::complement(student, t));
}

/// What makes Cohen's d unbiased: gamma(f/2) / (sqrt(f/2) gamma((f-1)/2)), f degrees of freedom
/// (Hedges 1981, equation 6e).
double hedges_correction(std::size_t n) {
  const double half = (static_cast<double>(n) - 1.0) / 2.0;
  return 1.0 / (std::sqrt(half) * boost::math::tgamma_delta_ratio(half - 1.0 / 2.0, 1.0 / 2.0));
}

void describe_equal(PairedDifference& difference) {
  const std::size_t n = difference.n;
  const bool zero = difference.mean == 0.0;
  const Interval point{difference.mean, difference.mean};
  difference.sd = 0.0;
  difference.all_equal = true;
  if (n >= 2) difference.student = point;
  if (n >= kLeastForBootstrap) difference.bootstrap = point;
  if (n >= kLeastForTest) difference.p = zero ? 1.0 : std::ldexp(1.0, 1 - static_cast<int>(n));
  if (n >= kLeastForTest && zero) difference.effect = 0.0;
}

void describe_varying(PairedDifference& difference, const std::vector<double>& sorted,
                      std::uint64_t seed) {
  const std::size_t n = difference.n;
  const double mean = difference.mean;
  difference.sd = standard_deviation(sorted, mean);
  const double half = student_half_width(difference.sd, n);
  difference.student = Interval{mean - half, mean + half};
  if (n >= kLeastForBootstrap) difference.bootstrap = bootstrap_mean(sorted, seed);
  if (n < kLeastForTest) return;
  difference.p = student_p(mean, difference.sd, n);
  difference.effect = hedges_correction(n) * mean / difference.sd;
}

}  // namespace

double welch_half_width(double sd_a, std::size_t n_a, double sd_b, std::size_t n_b) {
  const auto a = static_cast<double>(n_a), b = static_cast<double>(n_b);
  const double u = sd_a * sd_a / a, v = sd_b * sd_b / b;
  const double freedom = (u + v) * (u + v) / (u * u / (a - 1.0) + v * v / (b - 1.0));
  const boost::math::students_t student(freedom);
  return boost::math::quantile(boost::math::complement(student, kTail)) * std::sqrt(u + v);
}

SampleSummary summarize(std::span<const double> sample) {
  SampleSummary summary;
  summary.n = sample.size();
  if (sample.empty()) return summary;
  std::vector<double> sorted(sample.begin(), sample.end());
  std::ranges::sort(sorted);
  summary.min = sorted.front();
  summary.max = sorted.back();
  summary.mean = mean(sorted);
  summary.median = median(sorted);
  summary.quartile1 = quantile(sorted, kQuarter);
  summary.quartile3 = quantile(sorted, 1.0 - kQuarter);
  if (sorted.size() >= 2) summary.sd = standard_deviation(sorted, *summary.mean);
  return summary;
}

PairedDifference compare_pairs(std::span<const double> differences, std::uint64_t seed) {
  PairedDifference difference;
  difference.n = differences.size();
  if (differences.empty()) return difference;
  std::vector<double> sorted(differences.begin(), differences.end());
  std::ranges::sort(sorted);
  difference.mean = mean(sorted);
  const double range = sorted.back() - sorted.front();
  const double greatest = std::max(std::abs(sorted.front()), std::abs(sorted.back()));
  if (range <= kRounding * greatest) {
    describe_equal(difference);
  } else {
    describe_varying(difference, sorted, seed);
  }
  return difference;
}

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p[i]; });
  std::vector<double> corrected(p.size());
  double greatest = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const double times = static_cast<double>(order.size() - rank);
    greatest = std::max(greatest, std::min(times * p[order[rank]], 1.0));
    corrected[order[rank]] = greatest;
  }
  return corrected;
}

std::size_t seeds_needed(double sd, double half_width) {
  std::size_t low = kFewestSeeds, high = kMostSeeds;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (student_half_width(sd, middle) <= half_width) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

}  // namespace pedzone::study
