#include "study/report/median_seed.hpp"

#include <gmock/gmock.h>

namespace pedzone::study {
namespace {

using testing::ElementsAre;
using testing::Not;
using testing::Optional;

TEST(middle_row, is_the_median_of_one_column) {
  EXPECT_EQ(middle_row({{5.0}, {1.0}, {100.0}, {3.0}, {2.0}}), 3U);
}

TEST(middle_row, of_an_even_number_is_the_first_of_the_two) {
  EXPECT_EQ(middle_row({{1.0}, {4.0}, {3.0}, {2.0}}), 2U);
  EXPECT_EQ(middle_row({{1.0}, {2.0}, {3.0}, {4.0}}), 1U);
}

TEST(middle_row, weighs_columns_alike_whatever_their_unit) {
  // Ranks off the middle: 2+0, 1+1, 0+0, 1+2, 2+1.
  EXPECT_EQ(middle_row({{1.0, 300.0}, {2.0, 200.0}, {3.0, 300.0}, {4.0, 900.0}, {5.0, 500.0}}), 2U);
  // By rank row 1 (0+1); the other unit of the second column does not matter.
  EXPECT_EQ(middle_row({{1.0, 9e9}, {2.0, 1e9}, {3.0, 5e9}}), middle_row({{1, 9}, {2, 1}, {3, 5}}));
}

TEST(middle_row, shares_the_mean_rank_among_equal_values) {
  // The second column does not vary: it says nothing.
  EXPECT_EQ(middle_row({{3.0, 7.0}, {1.0, 7.0}, {2.0, 7.0}}), 2U);
  EXPECT_EQ(middle_row({{1.0}, {1.0}, {1.0}}), 0U);
}

TEST(middle_row, without_columns_is_the_first) { EXPECT_EQ(middle_row({{}, {}}), 0U); }

/// One scenario at three levels, given out of order: high, low, medium.
class MedianPairs : public testing::Test {
 protected:
  MedianPairs() {
    plan_.study.models = {"striping", "heuristic"};
    plan_.study.reference = "striping";
    plan_.study.seeds = {3, 5, 8};
    plan_.study.scenarios.push_back(
        {"s", PEDZONE_SCENARIOS "/plaza/plaza-low.sumocfg", "", {}, {}});
    plan_.study.factors = {
        {"demand", {scaled("high", "3"), scaled("low", "1"), scaled("medium", "2")}}};
    plan_.study.combinations = {{0}, {1}, {2}};
    plan_ = make_plan(plan_.study);
    records_.resize(plan_.runs.size());
    for (std::size_t c = 0; c < 3; ++c) {
      for (const std::uint64_t seed : plan_.study.seeds) {
        record("striping", c, seed, 100.0, 50.0);
        record("heuristic", c, seed, 100.0 - static_cast<double>(seed), 50.0);
      }
    }
  }

  static Level scaled(const std::string& name, const std::string& scale) {
    return {name, {{SettingKind::kSumo, "scale", scale, ""}}};
  }
  std::size_t run(const std::string& model, std::size_t condition, std::uint64_t seed) const {
    return plan_.run_of(RunKind::kStudy, condition, model, seed);
  }
  void record(const std::string& model, std::size_t condition, std::uint64_t seed, double time,
              double speed) {
    constexpr double kPersons[] = {300.0, 60.0, 160.0};
    RunRecord& record = records_[run(model, condition, seed)].emplace();
    record.measures = {{"person.travelTime", time},
                       {"person.speed", speed},
                       {"person.count", kPersons[condition]}};
  }

  Plan plan_;
  Records records_;
};

TEST_F(MedianPairs, come_from_the_condition_with_the_middle_number_of_people) {
  EXPECT_THAT(middle_condition(plan_, records_, 0), Optional(2U));
}

TEST_F(MedianPairs, have_no_condition_without_runs) {
  records_.assign(records_.size(), std::nullopt);
  EXPECT_EQ(middle_condition(plan_, records_, 0), std::nullopt);
  EXPECT_FALSE(median_pair(plan_, records_, 2, "heuristic").has_value());
}

TEST_F(MedianPairs, are_of_the_median_difference) {
  const auto pair = median_pair(plan_, records_, 2, "heuristic");
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->seed, 5U);
  EXPECT_EQ(pair->seeds, 3U);
  EXPECT_EQ(pair->reference, run("striping", 2, 5));
  EXPECT_EQ(pair->model, run("heuristic", 2, 5));
  EXPECT_THAT(pair->measures, ElementsAre("person.travelTime", "person.speed"));
}

TEST_F(MedianPairs, leave_out_seeds_that_lack_a_run) {
  records_[run("heuristic", 2, 5)]->status = RunStatus::kFailed;
  const auto pair = median_pair(plan_, records_, 2, "heuristic");
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->seeds, 2U);
  EXPECT_EQ(pair->seed, 3U);
}

TEST_F(MedianPairs, leave_out_measures_that_a_run_lacks) {
  records_[run("striping", 2, 8)]->measures.erase("person.speed");
  const auto pair = median_pair(plan_, records_, 2, "heuristic");
  ASSERT_TRUE(pair);
  EXPECT_THAT(pair->measures, ElementsAre("person.travelTime"));
}

}  // namespace
}  // namespace pedzone::study
