// What holds for statistics of any sample.
#include <gtest/gtest.h>
#include <rapidcheck.h>
// after GoogleTest, which it needs
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "core/random.hpp"
#include "study/compare/statistics.hpp"

namespace pedzone::study {
namespace {

// The same cases every time, unless the caller sets others.
[[maybe_unused]] const int kCases = setenv("RC_PARAMS", "seed=1 max_success=200", 0);

/// Values with ties and gaps, as measures have, in hundredths.
std::vector<double> any_sample(std::size_t least) {
  const auto numbers =
      *rc::gen::suchThat(rc::gen::container<std::vector<int>>(rc::gen::inRange(-500, 500)),
                         [=](const std::vector<int>& all) { return all.size() >= least; });
  std::vector<double> sample;
  for (const int number : numbers) sample.push_back(number / 100.0);
  return sample;
}

std::vector<double> any_p() {
  const auto numbers = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1001));
  std::vector<double> p;
  for (const int number : numbers) p.push_back(number / 1000.0);
  return p;
}

std::vector<std::size_t> any_order(std::size_t n) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {},
                    [&](std::size_t i) { return random_bits(seed, i, 0, Purpose::kTieBreak); });
  return order;
}

template <class T>
std::vector<T> reordered(const std::vector<T>& values, const std::vector<std::size_t>& order) {
  std::vector<T> result;
  for (const std::size_t i : order) result.push_back(values[i]);
  return result;
}

bool is_near(double a, double b, double scale) { return std::abs(a - b) <= 1e-9 * (scale + 1.0); }

bool equal(const std::optional<Interval>& a, const std::optional<Interval>& b) {
  return a.has_value() == b.has_value() && (!a || (a->low == b->low && a->high == b->high));
}

/// Whether b is a with every end moved to `factor` times it and `shift`.
bool moved(const std::optional<Interval>& a, const std::optional<Interval>& b, double factor,
           double shift) {
  if (a.has_value() != b.has_value()) return false;
  if (!a) return true;
  const double scale = std::abs(factor) * 10.0 + std::abs(shift);
  const double low = factor * a->low + shift, high = factor * a->high + shift;
  return is_near(std::min(low, high), b->low, scale) &&
         is_near(std::max(low, high), b->high, scale);
}

RC_GTEST_PROP(HolmProperty, corrects_upwards_and_keeps_the_order, ()) {
  const std::vector<double> p = any_p();
  const std::vector<double> corrected = holm(p);
  RC_ASSERT(corrected.size() == p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    RC_ASSERT(corrected[i] >= p[i]);
    RC_ASSERT(corrected[i] <= std::min(1.0, p[i] * static_cast<double>(p.size())));
    for (std::size_t j = 0; j < p.size(); ++j) {
      if (p[i] <= p[j]) RC_ASSERT(corrected[i] <= corrected[j]);
    }
  }
}

RC_GTEST_PROP(HolmProperty, is_indifferent_to_order, ()) {
  const std::vector<double> p = any_p();
  const auto order = any_order(p.size());
  RC_ASSERT(holm(reordered(p, order)) == reordered(holm(p), order));
}

RC_GTEST_PROP(DifferenceProperty, is_the_same_to_the_bit_in_any_order, ()) {
  const std::vector<double> sample = any_sample(0);
  const auto other = reordered(sample, any_order(sample.size()));
  const PairedDifference a = compare_pairs(sample, 1), b = compare_pairs(other, 1);
  RC_ASSERT(a.mean == b.mean);
  RC_ASSERT(a.sd == b.sd);
  RC_ASSERT(a.p == b.p);
  RC_ASSERT(a.effect == b.effect);
  RC_ASSERT(equal(a.student, b.student));
  RC_ASSERT(equal(a.bootstrap, b.bootstrap));
}

RC_GTEST_PROP(DifferenceProperty, moves_and_stretches_with_the_sample, ()) {
  const std::vector<double> sample = any_sample(0);
  const double factor = *rc::gen::inRange(1, 1000) / 10.0;
  const double shift = *rc::gen::inRange(-500, 500) / 10.0;
  std::vector<double> other = sample;
  for (double& value : other) value = factor * value + shift;
  const PairedDifference a = compare_pairs(sample, 1), b = compare_pairs(other, 1);
  RC_ASSERT(a.all_equal == b.all_equal);
  RC_ASSERT(a.n == 0 || is_near(factor * a.mean + shift, b.mean, factor * 10.0));
  RC_ASSERT(is_near(factor * a.sd, b.sd, factor * 10.0));
  RC_ASSERT(moved(a.student, b.student, factor, shift));
  RC_ASSERT(moved(a.bootstrap, b.bootstrap, factor, shift));
}

RC_GTEST_PROP(DifferenceProperty, of_the_models_exchanged_is_the_opposite, ()) {
  const std::vector<double> sample = any_sample(0);
  std::vector<double> other = sample;
  for (double& value : other) value = -value;
  const PairedDifference a = compare_pairs(sample, 1), b = compare_pairs(other, 1);
  RC_ASSERT(a.p.has_value() == b.p.has_value());
  RC_ASSERT(!a.p || is_near(*a.p, *b.p, 0.0));
  RC_ASSERT(a.effect.has_value() == b.effect.has_value());
  RC_ASSERT(!a.effect || is_near(*a.effect, -*b.effect, std::abs(*a.effect)));
  RC_ASSERT(moved(a.student, b.student, -1.0, 0.0));
}

RC_GTEST_PROP(DifferenceProperty, is_shown_where_the_interval_leaves_out_0, ()) {
  const std::vector<double> sample = any_sample(3);
  const PairedDifference difference = compare_pairs(sample, 1);
  RC_PRE(!difference.all_equal && std::abs(*difference.p - 0.05) > 1e-9);
  const bool outside = difference.student->low > 0.0 || difference.student->high < 0.0;
  RC_ASSERT(outside == (*difference.p < 0.05));
}

RC_GTEST_PROP(DifferenceProperty, lies_within_its_sample, ()) {
  const std::vector<double> sample = any_sample(10);
  const PairedDifference difference = compare_pairs(sample, 1);
  const auto [least, most] = std::ranges::minmax(sample);
  RC_ASSERT(difference.bootstrap->low >= least - 1e-9);
  RC_ASSERT(difference.bootstrap->high <= most + 1e-9);
  RC_ASSERT(difference.bootstrap->low <= difference.bootstrap->high);
  const SampleSummary summary = summarize(sample);
  RC_ASSERT(least <= *summary.quartile1 && *summary.quartile1 <= *summary.median);
  RC_ASSERT(*summary.median <= *summary.quartile3 && *summary.quartile3 <= most);
}

}  // namespace
}  // namespace pedzone::study
