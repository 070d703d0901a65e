#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "verify/verification.hpp"

namespace pedzone::verify {
namespace {

StandardTest test_of(Judged how) {
  StandardTest test;
  test.id = "a";
  test.figures = {{"value", "value", "", 2, 1.0, 2.0, "here", how}};
  test.charts = {{"curve", "", "", "", {}, {}, {}}};
  return test;
}

std::vector<Outcome> outcomes(std::initializer_list<double> values) {
  std::vector<Outcome> all;
  for (const double value : values) {
    all.push_back({{{"value", value}}, {{"curve", {{1.0, value}}}}, {}});
  }
  return all;
}

TEST(Judging, takes_the_median_of_the_seeds) {
  const TestResult result = judged(test_of(Judged::kMedian), outcomes({0.0, 1.5, 1.7}));
  EXPECT_TRUE(result.passed);
  EXPECT_DOUBLE_EQ(result.figures[0].value, 1.5);
  EXPECT_DOUBLE_EQ(result.figures[0].least, 0.0);
  EXPECT_DOUBLE_EQ(result.figures[0].most, 1.7);
  EXPECT_DOUBLE_EQ(result.curves[0][0].y, 1.5);
  EXPECT_DOUBLE_EQ(result.curves[0][0].most, 1.7);
}

TEST(Judging, takes_the_worst_where_every_seed_counts) {
  StandardTest test = test_of(Judged::kWorst);
  test.figures[0].most.reset();
  EXPECT_FALSE(judged(test, outcomes({0.0, 1.5, 1.7})).passed);
  EXPECT_TRUE(judged(test, outcomes({1.0, 1.5, 1.7})).passed);
}

TEST(Judging, lets_pass_what_is_only_reported_and_nothing_that_is_no_number) {
  EXPECT_TRUE(judged(test_of(Judged::kNot), outcomes({9.0})).passed);
  EXPECT_FALSE(judged(test_of(Judged::kMedian), outcomes({std::nan("")})).passed);
}

TEST(Judging, concludes_from_medians) {
  StandardTest test = test_of(Judged::kMedian);
  test.figures.push_back({"twice", "twice", "", 2, 3.0, 3.0, "here"});
  test.conclude = [](Outcome& outcome) {
    outcome.figures["twice"] = 2.0 * outcome.figures["value"];
  };
  const TestResult result = judged(test, outcomes({1.0, 1.5, 1.9}));
  EXPECT_DOUBLE_EQ(result.figures[1].value, 3.0);
  EXPECT_DOUBLE_EQ(result.figures[1].least, 2.0);
  EXPECT_TRUE(result.passed);
}

TEST(Verification, refuses_an_unknown_test_by_naming_all) {
  try {
    verify({{"heuristic"}, {"rimea-99"}, 1});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("rimea-99"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("rimea-1"), std::string::npos);
  }
}

TEST(Verification, is_the_same_twice_and_of_single_walkers_passed_by_the_default) {
  const VerifyOptions options{
      {"heuristic"}, {"rimea-1", "juelich-free-flow", "juelich-rotated", "juelich-drift"}, 2};
  const Verification first = verify(options), second = verify(options);
  ASSERT_EQ(first.tests.size(), 4U);
  for (std::size_t t = 0; t < first.tests.size(); ++t) {
    for (std::size_t f = 0; f < first.tests[t].figures.size(); ++f) {
      const FigureResult& figure = first.results[t][0].figures[f];
      EXPECT_EQ(figure.value, second.results[t][0].figures[f].value);
      EXPECT_TRUE(figure.passed) << first.tests[t].id << " " << figure.value;
    }
  }
}

}  // namespace
}  // namespace pedzone::verify
