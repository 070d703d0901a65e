#include "core/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pedzone {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double quantile(std::vector<double> sample, double q) {
  if (sample.empty()) return kNothing;
  const double place = q * static_cast<double>(sample.size() - 1);
  const auto low = static_cast<std::ptrdiff_t>(place);
  std::nth_element(sample.begin(), sample.begin() + low, sample.end());
  const double lower = sample[static_cast<std::size_t>(low)];
  const double share = place - static_cast<double>(low);
  if (share <= 0.0) return lower;
  const double upper = *std::min_element(sample.begin() + low + 1, sample.end());
  return std::isfinite(upper) ? lower + share * (upper - lower) : upper;
}

double mean(const std::vector<double>& sample) {
  if (sample.empty()) return kNothing;
  return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
}

double standard_deviation(const std::vector<double>& sample, double mean) {
  double squares = 0.0;
  for (const double value : sample) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (static_cast<double>(sample.size()) - 1.0));
}

double ks_distance(std::vector<double> a, std::vector<double> b) {
  if (a.empty() || b.empty()) return kNothing;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  double most = 0.0;
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    const double x = std::min(a[i], b[j]);
    while (i < a.size() && a[i] <= x) ++i;
    while (j < b.size() && b[j] <= x) ++j;
    const double difference = static_cast<double>(i) / static_cast<double>(a.size()) -
                              static_cast<double>(j) / static_cast<double>(b.size());
    most = std::max(most, std::abs(difference));
  }
  return most;
}

}  // namespace pedzone
