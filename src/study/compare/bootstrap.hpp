// An interval of a mean by resampling, for samples that are not normal.
#pragma once

#include <cstdint>
#include <span>

#include "study/compare/statistics.hpp"

namespace pedzone::study {

/// Of 10 normal values the interval covers the mean in 94.5 % of 4,000 samples, of 10 exponential
/// ones in 92.0 % (Student's: 89.0 %), of 20 in 93.7 %; of 5 normal ones only in 90.9 %. Without
/// widened tails it would be 89 % of 10 normal values.
inline constexpr std::size_t kLeastForBootstrap = 10;

/// 95 % interval of the mean: bias-corrected and accelerated (Efron 1987, Journal of the American
/// Statistical Association 82) from 2,000 resamples, its tails widened for small samples
/// (Hesterberg 2015, The American Statistician 69). `sample`: finite, not all the same, at least
/// 2. Another order of the sample draws other resamples.
Interval bootstrap_mean(std::span<const double> sample, std::uint64_t seed);

}  // namespace pedzone::study
