#include "core/random.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

namespace pedzone {
namespace {

constexpr int kDraws = 100'000;

TEST(Random, repeats_to_the_bit_and_differs_in_every_key) {
  const auto base = random_bits(1, 2, 3, Purpose::kHeadingNoise);
  EXPECT_EQ(base, random_bits(1, 2, 3, Purpose::kHeadingNoise));
  EXPECT_NE(base, random_bits(2, 2, 3, Purpose::kHeadingNoise));
  EXPECT_NE(base, random_bits(1, 3, 3, Purpose::kHeadingNoise));
  EXPECT_NE(base, random_bits(1, 2, 4, Purpose::kHeadingNoise));
  EXPECT_NE(base, random_bits(1, 2, 3, Purpose::kPlacement));
}

TEST(Random, is_uniform_over_steps) {
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random_uniform(7, person_key("ped"), static_cast<std::uint64_t>(i),
                                    Purpose::kTieBreak);
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  // Mean 1/2 and second moment 1/3, within five standard errors.
  EXPECT_NEAR(sum / kDraws, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / kDraws));
}

TEST(Random, normal_numbers_have_mean_0_and_variance_1_over_persons) {
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double z = random_normal(7, person_key("p" + std::to_string(i)), 0,
                                   Purpose::kHeadingNoise);
    ASSERT_TRUE(std::isfinite(z));
    sum += z;
    squares += z * z;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 5.0 / std::sqrt(double{kDraws}));
  EXPECT_NEAR(squares / kDraws, 1.0, 5.0 * std::sqrt(2.0 / kDraws));
}

TEST(PersonKey, differs_between_ids) {
  std::set<std::uint64_t> keys;
  for (int i = 0; i < kDraws; ++i) keys.insert(person_key("ped" + std::to_string(i)));
  EXPECT_EQ(keys.size(), static_cast<std::size_t>(kDraws));
}

}  // namespace
}  // namespace pedzone
