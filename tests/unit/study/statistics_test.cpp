// Statistics against published examples, figures worked out by hand, and simulated data.
#include "study/compare/statistics.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/random.hpp"

namespace pedzone::study {
namespace {

constexpr std::uint64_t kSeed = 7;

/// Hours of sleep gained by ten patients with two drugs, the second less the first (Student 1908,
/// "The probable error of a mean", Biometrika 6, p. 20).
const std::vector<double> kSleep = {1.2, 2.4, 1.3, 1.3, 0.0, 1.0, 1.8, 0.8, 4.6, 1.4};

TEST(Summary, is_that_of_the_order_statistics) {
  const SampleSummary summary = summarize(std::vector<double>{4, 1, 3, 2, 10});
  EXPECT_EQ(summary.n, 5u);
  EXPECT_DOUBLE_EQ(*summary.mean, 4.0);
  EXPECT_DOUBLE_EQ(*summary.median, 3.0);
  EXPECT_DOUBLE_EQ(*summary.sd, std::sqrt(50.0 / 4.0));
  EXPECT_DOUBLE_EQ(*summary.min, 1.0);
  EXPECT_DOUBLE_EQ(*summary.max, 10.0);
  EXPECT_DOUBLE_EQ(*summary.quartile1, 2.0);
  EXPECT_DOUBLE_EQ(*summary.quartile3, 4.0);
}

TEST(Summary, leaves_unset_what_few_values_do_not_define) {
  const SampleSummary none = summarize({});
  EXPECT_EQ(none.n, 0u);
  EXPECT_FALSE(none.mean || none.median || none.sd || none.min || none.max || none.quartile1);
  const SampleSummary one = summarize(std::vector<double>{3.5});
  EXPECT_EQ(*one.mean, 3.5);
  EXPECT_EQ(*one.quartile3, 3.5);
  EXPECT_FALSE(one.sd);
}

TEST(PairedDifference, of_Students_sleep_data_is_the_published_one) {
  // t = 4.0621 with 9 degrees of freedom, p = 0.002833, interval 0.7001142 to 2.4598858: example of
  // t.test() in R's manual, dataset `sleep`.
  const PairedDifference difference = compare_pairs(kSleep, kSeed);
  EXPECT_EQ(difference.n, 10u);
  EXPECT_NEAR(difference.mean, 1.58, 1e-12);
  EXPECT_NEAR(difference.mean / (difference.sd / std::sqrt(10.0)), 4.0621, 5e-5);
  EXPECT_NEAR(*difference.p, 0.002833, 5e-7);
  EXPECT_NEAR(difference.student->low, 0.7001142, 5e-8);
  EXPECT_NEAR(difference.student->high, 2.4598858, 5e-8);
  EXPECT_FALSE(difference.all_equal);
}

TEST(PairedDifference, of_three_pairs_is_the_one_worked_out_by_hand) {
  // Mean 2, deviation 1: t = 2 sqrt(3). With 2 degrees of freedom the tail beyond t is
  // (1 - t / sqrt(2 + t^2)) / 2, and Hedges' correction is 1 / sqrt(pi).
  const PairedDifference difference = compare_pairs(std::vector<double>{3, 1, 2}, kSeed);
  const double t = 2.0 * std::sqrt(3.0);
  EXPECT_NEAR(*difference.p, 1.0 - t / std::sqrt(2.0 + t * t), 1e-12);
  EXPECT_NEAR(*difference.effect, 2.0 / std::sqrt(std::numbers::pi), 1e-12);
  // The quantile is (2q - 1) / sqrt(2 q (1 - q)) at q = 0.975.
  const double half = 0.95 / std::sqrt(2.0 * 0.975 * 0.025) / std::sqrt(3.0);
  EXPECT_NEAR(difference.student->low, 2.0 - half, 1e-12);
  EXPECT_NEAR(difference.student->high, 2.0 + half, 1e-12);
  EXPECT_FALSE(difference.bootstrap) << "too few to resample";
}

TEST(PairedDifference, has_no_test_without_an_effect_size) {
  for (std::size_t n = 0; n < 12; ++n) {
    std::vector<double> differences(n);
    for (std::size_t i = 0; i < n; ++i) differences[i] = std::sqrt(static_cast<double>(i));
    const PairedDifference difference = compare_pairs(differences, kSeed);
    EXPECT_EQ(difference.n, n);
    EXPECT_EQ(difference.student.has_value(), n >= 2) << n;
    EXPECT_EQ(difference.p.has_value(), n >= 3) << n;
    EXPECT_EQ(difference.effect.has_value(), n >= 3) << n;
    EXPECT_EQ(difference.bootstrap.has_value(), n >= 10) << n;
  }
}

TEST(PairedDifference, that_is_the_same_in_every_pair_is_a_point_with_a_sign_test) {
  const PairedDifference difference = compare_pairs(std::vector<double>(12, -0.1), kSeed);
  EXPECT_TRUE(difference.all_equal);
  EXPECT_EQ(difference.sd, 0.0);
  EXPECT_EQ(difference.student->low, difference.student->high);
  EXPECT_EQ(difference.bootstrap->low, difference.bootstrap->high);
  EXPECT_NEAR(difference.student->low, -0.1, 1e-15);
  EXPECT_EQ(*difference.p, 1.0 / 2048.0) << "all 12 signs alike: 2 / 2^12";
  EXPECT_FALSE(difference.effect) << "would be infinite";
}

TEST(PairedDifference, that_varies_by_rounding_only_does_not_vary) {
  std::vector<double> differences;
  for (const double base : {0.3, 1.7, 2.9, 11.1}) differences.push_back((base + 0.1) - base);
  EXPECT_NE(differences.front(), differences.back());
  EXPECT_TRUE(compare_pairs(differences, kSeed).all_equal);
}

TEST(PairedDifference, of_equal_values_is_none) {
  const PairedDifference difference = compare_pairs(std::vector<double>(5, 0.0), kSeed);
  EXPECT_TRUE(difference.all_equal);
  EXPECT_EQ(*difference.p, 1.0);
  EXPECT_EQ(*difference.effect, 0.0);
  EXPECT_FALSE(compare_pairs({}, kSeed).all_equal) << "nothing is not the same";
  EXPECT_FALSE(compare_pairs(std::vector<double>{0.0}, kSeed).p);
}

TEST(Holm, is_the_worked_example) {
  // 4 hypotheses; smallest times 4, next times 3, ... never less than the one before.
  EXPECT_THAT(
      holm(std::vector<double>{0.01, 0.04, 0.03, 0.005}),
      testing::Pointwise(testing::DoubleNear(1e-15), std::vector<double>{0.03, 0.06, 0.06, 0.02}));
  EXPECT_THAT(holm(std::vector<double>{0.5, 0.9}), testing::ElementsAre(1.0, 1.0));
  EXPECT_THAT(holm(std::vector<double>{0.04}), testing::ElementsAre(0.04));
  EXPECT_THAT(holm({}), testing::IsEmpty());
}

TEST(SeedsNeeded, are_those_of_a_table_of_t) {
  // Half width t sd / sqrt(n), t of any table: 6 give 2.571 / sqrt(6) = 1.05, 7 give 0.925; 17 give
  // 2.120 / sqrt(17) = 0.514, 18 give 0.497.
  EXPECT_EQ(seeds_needed(1.0, 1.0), 7u);
  EXPECT_EQ(seeds_needed(10.0, 5.0), 18u);
  EXPECT_EQ(seeds_needed(0.0, 1.0), 2u);
  EXPECT_EQ(seeds_needed(1.0, 1e-9), 1'000'000u) << "not to be had";
}

/// Share of 2,000 samples for which something holds.
double share_of_samples(std::size_t n,
                        const std::function<double(std::uint64_t, std::uint64_t)>& draw,
                        const std::function<bool(const PairedDifference&)>& holds) {
  constexpr std::uint64_t kSamples = 2000;
  int holding = 0;
  for (std::uint64_t repetition = 0; repetition < kSamples; ++repetition) {
    std::vector<double> sample(n);
    for (std::size_t i = 0; i < n; ++i) sample[i] = draw(repetition, i);
    if (holds(compare_pairs(sample, repetition))) ++holding;
  }
  return holding / static_cast<double>(kSamples);
}

double normal(std::uint64_t repetition, std::uint64_t i) {
  return 3.0 + 2.0 * random_normal(kSeed, repetition, i, Purpose::kHeadingNoise);
}

/// Skewed: mean 3, deviation 2.
double exponential(std::uint64_t repetition, std::uint64_t i) {
  return 1.0 - 2.0 * std::log1p(-random_uniform(kSeed, repetition, i, Purpose::kHeadingNoise));
}

/// Difference of two counts with mean 2 each, and 3: whole numbers with many ties.
double counts(std::uint64_t repetition, std::uint64_t i) {
  const auto count = [&](std::uint64_t which) {  // Knuth's: factors until their product is small
    int number = 0;
    double product = 1.0;
    for (std::uint64_t factor = 0;; ++factor, ++number) {
      product *=
          random_uniform(kSeed + 1 + which, repetition, 64 * i + factor, Purpose::kHeadingNoise);
      if (product <= std::exp(-2.0)) return static_cast<double>(number);
    }
  };
  return 3.0 + count(0) - count(1);
}

bool holds_3(const std::optional<Interval>& interval) {
  return interval->low <= 3.0 && 3.0 <= interval->high;
}

bool student_holds_3(const PairedDifference& difference) { return holds_3(difference.student); }
bool bootstrap_holds_3(const PairedDifference& difference) { return holds_3(difference.bootstrap); }

/// "95 %", at 2,000 samples.
testing::Matcher<double> about_95_percent() {
  return testing::AllOf(testing::Ge(0.93), testing::Le(0.97));
}

TEST(Coverage, of_Students_interval_is_95_percent) {
  for (const std::size_t n : {2u, 3u, 5u, 9u, 30u}) {
    EXPECT_THAT(share_of_samples(n, normal, student_holds_3), about_95_percent()) << n;
  }
}

TEST(Coverage, of_the_bootstrap_interval_is_95_percent) {
  for (const std::size_t n : {10u, 20u, 50u}) {
    EXPECT_THAT(share_of_samples(n, normal, bootstrap_holds_3), about_95_percent()) << n;
  }
}

TEST(Coverage, of_the_bootstrap_interval_of_counts_is_95_percent) {
  for (const std::size_t n : {10u, 20u}) {
    EXPECT_THAT(share_of_samples(n, counts, bootstrap_holds_3), about_95_percent()) << n;
  }
}

TEST(Coverage, of_the_bootstrap_interval_of_skewed_values_is_95_percent) {
  const double at_20 = share_of_samples(20, exponential, bootstrap_holds_3);
  EXPECT_THAT(at_20, about_95_percent());
  EXPECT_THAT(share_of_samples(30, exponential, bootstrap_holds_3), about_95_percent());
  EXPECT_GT(at_20, share_of_samples(20, exponential, student_holds_3)) << "what it is for";
}

TEST(Coverage, of_the_test_is_95_percent_where_there_is_no_difference) {
  const auto centred = [](std::uint64_t repetition, std::uint64_t i) {
    return normal(repetition, i) - 3.0;
  };
  EXPECT_THAT(share_of_samples(10, centred, [](const PairedDifference& d) { return *d.p >= 0.05; }),
              about_95_percent());
}

TEST(Coverage, of_the_seeds_needed_is_about_one_half) {
  // The deviation of a sample is less than the true one a little more often than not.
  const std::size_t n = seeds_needed(2.0, 1.0);
  const double reached = share_of_samples(n, normal, [](const PairedDifference& difference) {
    return (difference.student->high - difference.student->low) / 2.0 <= 1.0;
  });
  EXPECT_THAT(reached, testing::AllOf(testing::Ge(0.45), testing::Le(0.6)));
}

TEST(EffectSize, is_unbiased) {
  double sum = 0.0;
  share_of_samples(5, normal, [&](const PairedDifference& difference) {
    sum += *difference.effect;
    return true;
  });
  // Mean 3, deviation 2. Standard error of the mean of 2,000: about 0.02; without the correction it
  // would be 1.25 times as much.
  EXPECT_NEAR(sum / 2000.0, 1.5, 0.08);
}

TEST(Welch, is_students_interval_for_samples_that_vary_alike) {
  // n = 8 and 8 of sd 2: 14 degrees of freedom, t = 2.14479, standard error 1.
  EXPECT_NEAR(welch_half_width(2.0, 8, 2.0, 8), 2.14479, 1e-5);
  // Only one varies: its own degrees of freedom.
  EXPECT_NEAR(welch_half_width(2.0, 4, 0.0, 9), 3.18245, 1e-5);
}

}  // namespace
}  // namespace pedzone::study
