// Axes: steps are 1, 2 or 5 times a power of ten, ends are covered, ticks are even.
#include "view/axis.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace pedzone {
namespace {

/// Ranges of many sizes and places.
std::vector<std::pair<double, double>> ranges() {
  std::vector<std::pair<double, double>> all;
  for (const double size : {0.013, 0.1, 0.99, 1.0, 1.01, 7.3, 60.0, 123.4, 3599.0, 86400.0}) {
    for (const double start : {0.0, -0.37, 12.3, -5000.0, 1e5}) {
      all.emplace_back(start, start + size);
    }
  }
  return all;
}

TEST(RoundStep, is_1_2_or_5_times_a_power_of_ten_and_cuts_into_few_parts) {
  for (const auto& [least, most] : ranges()) {
    for (const double parts : {1.0, 4.0, 8.0, 20.0}) {
      const double step = round_step(most - least, parts);
      const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
      EXPECT_THAT(std::lround(mantissa), testing::AnyOf(1, 2, 5)) << step;
      EXPECT_NEAR(mantissa, static_cast<double>(std::lround(mantissa)), 1e-9);
      EXPECT_LE((most - least) / step, parts * (1.0 + 1e-9));
      EXPECT_GT((most - least) / step, parts / 2.5 * (1.0 - 1e-9)) << "not coarser than need be";
    }
  }
}

TEST(RoundStep, of_no_range_is_1) {
  EXPECT_EQ(round_step(0.0, 5.0), 1.0);
  EXPECT_EQ(round_step(-3.0, 5.0), 1.0);
  EXPECT_EQ(round_step(std::nan(""), 5.0), 1.0);
}

TEST(RoundLength, is_the_longest_that_fits) {
  for (const auto& [most, length] : {std::pair(1.0, 1.0), {1.9, 1.0}, {2.0, 2.0}, {4.9, 2.0},
                                     {5.0, 5.0}, {9.9, 5.0}, {62.0, 50.0}, {0.03, 0.02}}) {
    EXPECT_DOUBLE_EQ(round_length(most), length);
  }
}

TEST(Axis, covers_both_ends_with_ticks_at_multiples_of_its_step) {
  for (const auto& [least, most] : ranges()) {
    const Axis axis = Axis::over(least, most, 6.0);
    EXPECT_LE(axis.least, least + 1e-6 * axis.step);
    EXPECT_GE(axis.most, most - 1e-6 * axis.step);
    EXPECT_GT(axis.least, least - axis.step) << "no longer than need be";
    EXPECT_LT(axis.most, most + axis.step);
    const auto ticks = axis.ticks();
    ASSERT_GE(ticks.size(), 2U);
    EXPECT_NEAR(ticks.front(), axis.least, 1e-9 * std::abs(axis.least) + 1e-12);
    EXPECT_NEAR(ticks.back(), axis.most, 1e-9 * std::abs(axis.most) + 1e-12);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      EXPECT_NEAR(ticks[i] - ticks[i - 1], axis.step, 1e-6 * axis.step);
    }
  }
}

TEST(Axis, of_a_single_value_has_a_step) {
  const Axis axis = Axis::over(3.0, 3.0, 6.0);
  EXPECT_EQ(axis.least, 3.0);
  EXPECT_EQ(axis.most, 4.0);
}

TEST(Axis, labels_have_the_digits_that_the_step_needs) {
  EXPECT_EQ(Axis::over(0.0, 1.2, 6.0).label(0.4), "0.4");
  EXPECT_EQ(Axis::over(0.0, 0.05, 5.0).label(0.03), "0.03");
  EXPECT_EQ(Axis::over(0.0, 300.0, 6.0).label(150.0), "150");
  EXPECT_EQ(Axis::over(-2.0, 4.0, 6.0).label(-1.0), "-1");
}

TEST(Axis, part_is_0_and_1_at_the_ends) {
  const Axis axis = Axis::over(-3.0, 17.0, 5.0);
  EXPECT_EQ(axis.part(axis.least), 0.0);
  EXPECT_EQ(axis.part(axis.most), 1.0);
}

}  // namespace
}  // namespace pedzone
