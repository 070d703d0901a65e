// The few statistics that scores need. All take copies and are indifferent to order.
#pragma once

#include <vector>

namespace pedzone {

/// Quantile `q` [0, 1] with linear interpolation between order statistics (Hyndman and Fan 1996,
/// type 7). NaN for an empty sample.
double quantile(std::vector<double> sample, double q);
inline double median(std::vector<double> sample) { return quantile(std::move(sample), 0.5); }
/// NaN for an empty sample.
double mean(const std::vector<double>& sample);
/// Of a sample of at least two with this mean: divided by one less than their number.
double standard_deviation(const std::vector<double>& sample, double mean);
/// Two-sample Kolmogorov–Smirnov distance, [0, 1]. NaN when one is empty.
double ks_distance(std::vector<double> a, std::vector<double> b);

}  // namespace pedzone
