#include "conflict/gap_acceptance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pedzone {
namespace {

// Drawn from P = 1 / (1 + exp(5 - 0.9 g)). The expected numbers are scipy's, which minimised the
// same likelihood.
const std::vector<GapChoice> kChoices{
    {3.6, false}, {7.0, true},  {5.1, false}, {7.6, true},   {7.9, true},   {1.7, false},
    {1.1, false}, {10.2, true}, {3.9, false}, {3.6, false},  {12.0, true},  {6.2, false},
    {10.2, true}, {6.2, false}, {8.0, true},  {2.7, false},  {8.0, true},   {10.5, true},
    {6.8, false}, {9.2, true},  {8.4, true},  {1.7, false},  {9.3, true},   {7.5, true},
    {4.3, false}, {1.3, false}, {10.5, true}, {6.2, false},  {8.9, true},   {10.7, true},
    {8.9, true},  {11.1, true}, {5.3, true},  {9.8, true},   {5.9, false},  {11.3, true},
    {10.7, true}, {2.1, false}, {2.5, false}, {3.4, false}};

TEST(GapAcceptance, is_the_logistic_regression_that_scipy_finds) {
  const auto fit = fit_gap_acceptance(kChoices);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->intercept, -13.58174251, 1e-4);
  EXPECT_NEAR(fit->slope, 2.05311904, 1e-5);
  EXPECT_NEAR(fit->median, 6.61517538, 1e-6);
  EXPECT_NEAR(fit->low, 5.90143880, 1e-4);
  EXPECT_NEAR(fit->high, 7.32891196, 1e-4);
  EXPECT_EQ(fit->taken, 22U);
  EXPECT_EQ(fit->left, 18U);
}

TEST(GapAcceptance, is_one_gap_where_that_parts_what_was_taken_from_what_was_left) {
  std::vector<GapChoice> choices;
  for (int k = 0; k < 6; ++k) {
    choices.push_back({3.0 - 0.1 * k, false});
    choices.push_back({5.0 + 0.1 * k, true});
  }
  const auto fit = fit_gap_acceptance(choices);
  ASSERT_TRUE(fit);
  EXPECT_DOUBLE_EQ(fit->median, 4.0);
  EXPECT_TRUE(std::isinf(fit->slope));
}

TEST(GapShares, are_of_each_second_that_has_gaps) {
  const auto shares = shares_taken(std::vector<GapChoice>{{2.0, false},
                                                          {2.9, true},
                                                          {2.4, false},
                                                          {2.5, false},
                                                          {7.1, true},
                                                          {20.0, true},
                                                          {-0.1, false}});
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_EQ(shares[0].gap, 2.5);
  EXPECT_EQ(shares[0].share, 0.25);
  EXPECT_EQ(shares[0].gaps, 4U);
  EXPECT_EQ(shares[1].gap, 7.5);
  EXPECT_EQ(shares[1].share, 1.0);
}

TEST(GapAcceptance, is_nothing_where_gaps_are_few_or_the_short_ones_are_taken) {
  EXPECT_FALSE(fit_gap_acceptance({}));
  EXPECT_FALSE(fit_gap_acceptance(std::span(kChoices).first(8)));
  std::vector<GapChoice> turned = kChoices;
  for (GapChoice& choice : turned) choice.taken = !choice.taken;
  EXPECT_FALSE(fit_gap_acceptance(turned));
}

}  // namespace
}  // namespace pedzone
