// Comparisons, fairness and tables of studies whose records are known.
#include "study/compare/results.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "study/measure/measure_list.hpp"

namespace pedzone::study {
namespace {

using testing::HasSubstr;

/// A study with a factor of two levels, hostile names among them.
Study two_levels(std::vector<std::uint64_t> seeds) {
  Study study;
  study.id = "test";
  study.scenarios = {{"town, \"old\"", PEDZONE_SCENARIOS "/plaza/plaza-low.sumocfg", "", {}, {}}};
  study.models = {"striping", "heuristic", "orca"};
  study.reference = "striping";
  study.seeds = std::move(seeds);
  study.factors = {{"seed",
                    {{"few", {{SettingKind::kSumo, "scale", "1", ""}}},
                     {"m,any", {{SettingKind::kSumo, "scale", "2", ""}}}}}};
  study.combinations = {{0}, {1}};
  return study;
}

class ResultsTest : public testing::Test {
 protected:
  explicit ResultsTest(std::vector<std::uint64_t> seeds = {1, 2, 3, 4, 5})
      : plan(make_plan(two_levels(std::move(seeds)))), records(plan.runs.size()) {}

  std::optional<RunRecord>& at(std::size_t condition, const std::string& model, std::uint64_t seed,
                               RunKind kind = RunKind::kStudy) {
    return records[plan.run_of(kind, condition, model, seed)];
  }

  void measure(std::size_t condition, const std::string& model, const std::string& key,
               const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      auto& record = at(condition, model, plan.study.seeds[i]);
      if (!record) record.emplace();
      record->measures[key] = values[i];
    }
  }

  Comparison comparison(std::size_t condition, const std::string& model, const std::string& key) {
    for (const Comparison& each : compare(plan, records)) {
      const bool found = each.condition == condition && each.model == model && each.measure == key;
      if (found) return each;
    }
    ADD_FAILURE() << "no such comparison";
    return {};
  }

  Plan plan;
  Records records;
};

constexpr const char* kTime = "person.travelTime";
constexpr const char* kWaiting = "person.waiting";

TEST_F(ResultsTest, there_is_one_for_each_condition_model_and_measure) {
  const auto all = compare(plan, records);
  ASSERT_EQ(all.size(), 2 * 2 * measure_list().size());
  EXPECT_EQ(all.front().model, "heuristic");
  EXPECT_EQ(all.front().measure, kTime);
  EXPECT_EQ(all.back().condition, 1u);
  EXPECT_EQ(all.back().model, "orca");
  for (const Comparison& each : all) {
    EXPECT_EQ(each.finding, Finding::kTooFew);
    EXPECT_EQ(each.missing, 5u);
  }
}

TEST_F(ResultsTest, pairs_are_of_one_seed) {
  measure(1, "striping", kTime, {100, 120, 140, 160, 180});
  measure(1, "heuristic", kTime, {101, 122, 143, 164, 185});
  const Comparison found = comparison(1, "heuristic", kTime);
  EXPECT_EQ(found.difference.n, 5u);
  EXPECT_DOUBLE_EQ(found.difference.mean, 3.0);
  EXPECT_DOUBLE_EQ(found.difference.sd, std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(*found.reference.mean, 140.0);
  EXPECT_DOUBLE_EQ(*found.sample.mean, 143.0);
  EXPECT_DOUBLE_EQ(*found.relative, 3.0 / 140.0);
  EXPECT_EQ(found.p_holm, found.difference.p) << "alone in its family";
  EXPECT_EQ(found.finding, Finding::kDifferent) << "far smaller than the spread over seeds";
  EXPECT_EQ(found.seeds_needed, seeds_needed(std::sqrt(2.5), 7.0));
}

TEST_F(ResultsTest, failed_runs_and_undefined_values_drop_out_of_pairs_and_are_counted) {
  measure(0, "striping", kTime, {10, 20, 30, 40, 50});
  measure(0, "heuristic", kTime, {11, 22, 33, 44, 55});
  at(0, "heuristic", 2)->status = RunStatus::kFailed;
  at(0, "striping", 4).reset();
  at(0, "striping", 5)->measures[kTime] = std::numeric_limits<double>::quiet_NaN();
  const Comparison found = comparison(0, "heuristic", kTime);
  EXPECT_EQ(found.difference.n, 2u);
  EXPECT_DOUBLE_EQ(found.difference.mean, 2.0);
  EXPECT_DOUBLE_EQ(*found.reference.mean, 20.0) << "of the pairs";
  EXPECT_EQ(found.missing, 2u);
  EXPECT_EQ(found.undefined, 1u);
  EXPECT_EQ(found.finding, Finding::kTooFew);
  EXPECT_EQ(comparison(0, "heuristic", kWaiting).undefined, 3u);
}

TEST_F(ResultsTest, findings_tell_no_difference_from_no_knowledge) {
  measure(0, "striping", kTime, {100, 100, 100, 100, 100});
  measure(0, "heuristic", kTime, {101, 99, 102, 98, 100.5});
  EXPECT_EQ(comparison(0, "heuristic", kTime).finding, Finding::kNotShown);
  measure(0, "heuristic", kTime, {150, 50, 140, 60, 100.5});
  EXPECT_EQ(comparison(0, "heuristic", kTime).finding, Finding::kInconclusive);
  measure(0, "heuristic", kTime, {100, 100, 100, 100, 100});
  EXPECT_EQ(comparison(0, "heuristic", kTime).finding, Finding::kSame);
  measure(0, "heuristic", kTime, {101, 101, 101, 101, 101});
  const Comparison few = comparison(0, "heuristic", kTime);
  EXPECT_EQ(*few.difference.p, 1.0 / 16.0);
  EXPECT_EQ(few.finding, Finding::kInconclusive) << "5 equal signs come by chance in 1 of 16";
}

TEST_F(ResultsTest, what_only_counts_by_itself_is_a_hint) {
  measure(0, "striping", kTime, {100, 100, 100, 100, 100});
  measure(0, "heuristic", kTime, {96, 99, 97, 99.5, 95});
  EXPECT_EQ(comparison(0, "heuristic", kTime).finding, Finding::kDifferent) << "alone";
  measure(0, "striping", kWaiting, {10, 10, 10, 10, 10});
  measure(0, "heuristic", kWaiting, {11, 9, 10.5, 9.5, 10.1});
  const Comparison found = comparison(0, "heuristic", kTime);
  EXPECT_LT(*found.difference.p, 0.05);
  EXPECT_GE(*found.p_holm, 0.05);
  EXPECT_LT(found.difference.student->high, 0.0);
  EXPECT_EQ(found.finding, Finding::kHint);
}

TEST_F(ResultsTest, nothing_is_divided_by_a_reference_of_zero) {
  measure(0, "striping", kTime, {0, 0, 0, 0, 0});
  measure(0, "heuristic", kTime, {0, 1, 0, 0, 0});
  const Comparison found = comparison(0, "heuristic", kTime);
  EXPECT_FALSE(found.relative);
  EXPECT_EQ(found.seeds_needed, 0u);
  EXPECT_EQ(found.finding, Finding::kInconclusive);
}

TEST_F(ResultsTest, values_that_differ_by_rounding_are_the_same) {
  measure(0, "striping", kTime, {0.3, 0.3, 0.3});
  measure(0, "heuristic", kTime, {0.1 + 0.2, 0.3, 0.1 + 0.2});
  EXPECT_EQ(comparison(0, "heuristic", kTime).finding, Finding::kSame);
}

TEST_F(ResultsTest, p_values_are_corrected_within_their_family) {
  const std::vector<double> base = {100, 120, 140, 160, 180};
  measure(0, "striping", kTime, base);
  measure(0, "heuristic", kTime, {101, 122, 143, 164, 185});
  measure(0, "orca", kTime, {101, 121, 139, 162, 181});
  measure(0, "striping", "person.walked", base);
  measure(0, "heuristic", "person.walked", {101, 121, 139, 162, 181});
  const Comparison first = comparison(0, "heuristic", kTime);
  const Comparison second = comparison(0, "orca", kTime);
  ASSERT_LT(*first.difference.p, *second.difference.p);
  EXPECT_EQ(*first.p_holm, 2.0 * *first.difference.p);
  EXPECT_EQ(*second.p_holm, *second.difference.p);
  const Comparison detail = comparison(0, "heuristic", "person.walked");
  EXPECT_EQ(*detail.p_holm, *detail.difference.p);
}

TEST_F(ResultsTest, a_comparison_is_the_same_to_the_bit_in_a_larger_study) {
  const std::vector<double> base = {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048};
  const auto bootstrap = [&](Study study) {
    plan = make_plan(std::move(study));
    records.assign(plan.runs.size(), std::nullopt);
    measure(0, "striping", kTime, std::vector<double>(12, 1.0));
    measure(0, "orca", kTime, base);
    return *comparison(0, "orca", kTime).difference.bootstrap;
  };
  Study small = two_levels({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  Study large = small;
  small.models = {"striping", "orca"};
  EXPECT_EQ(bootstrap(small).low, bootstrap(large).low);
}

TEST_F(ResultsTest, times_that_are_cut_off_are_not_said_to_be_the_same) {
  measure(0, "striping", kTime, {100, 100, 100, 100, 100});
  measure(0, "heuristic", kTime, {101, 99, 102, 98, 100.5});
  EXPECT_EQ(comparison(0, "heuristic", kTime).finding, Finding::kNotShown);
  measure(0, "striping", "person.arrived", {1, 1, 1, 1, 1});
  measure(0, "heuristic", "person.arrived", {0.8, 0.82, 0.79, 0.8, 0.81});
  EXPECT_EQ(comparison(0, "heuristic", kTime).bound, Bound::kUnknown);
}

TEST_F(ResultsTest, free_speeds_are_compared_person_by_person) {
  const auto walked = [&](const std::string& model, std::map<std::string, double> speeds) {
    auto& record = at(0, model, 1, RunKind::kFreeSpeed).emplace();
    for (const auto& [id, speed] : speeds) {
      record.measures["speed:" + id] = speed;
      record.measures["way:" + id] = 100.0 * speed;  // as long as it is fast
      record.measures["time:" + id] = 100.0;
    }
  };
  walked("striping", {{"a", 1.0}, {"b", 2.0}, {"c", 1.5}, {"still", 0.0}});
  walked("heuristic", {{"a", 1.01}, {"b", 1.98}, {"d", 9.0}, {"still", 1.0}});
  walked("orca", {{"a", 1.03}, {"b", 2.0}, {"c", 1.56}});
  const auto speeds = free_speeds(plan, records);
  ASSERT_EQ(speeds.size(), 4u);
  EXPECT_EQ(speeds[0].persons, 2u);
  EXPECT_DOUBLE_EQ(speeds[0].ratio, 1.0);
  EXPECT_DOUBLE_EQ(speeds[0].lowest, 0.99);
  EXPECT_DOUBLE_EQ(speeds[0].highest, 1.01);
  EXPECT_TRUE(speeds[0].agrees);
  EXPECT_NEAR(*speeds[0].way.mean, -1.0 / 300.0, 1e-12) << "of all together";
  EXPECT_NEAR(*speeds[1].way.mean, 9.0 / 450.0, 1e-12);
  EXPECT_EQ(speeds[1].time.mean, 0.0);
  EXPECT_NEAR(speeds[1].ratio, (1.03 + 1.0 + 1.04) / 3.0, 1e-12);
  EXPECT_FALSE(speeds[1].agrees);
  EXPECT_EQ(speeds[2].persons, 0u);
  EXPECT_FALSE(speeds[2].agrees) << "not measured";
}

TEST_F(ResultsTest, unequal_demand_is_told_by_seed) {
  for (const std::uint64_t seed : plan.study.seeds) {
    for (const std::string& model : plan.study.models) {
      at(0, model, seed).emplace().demand = {{"persons", "p"}, {"vehicles", "v"}};
    }
  }
  EXPECT_TRUE(unequal_demands(plan, records).empty());
  at(0, "orca", 2)->demand["vehicles"] = "w";
  at(0, "orca", 5)->demand["vehicles"] = "x";
  at(0, "orca", 3)->status = RunStatus::kFailed;
  at(0, "orca", 3)->demand.clear();
  const auto unequal = unequal_demands(plan, records);
  ASSERT_EQ(unequal.size(), 1u);
  EXPECT_EQ(unequal[0].model, "orca");
  EXPECT_EQ(unequal[0].what, "vehicles");
  EXPECT_THAT(unequal[0].seeds, testing::ElementsAre(2, 5));
}

TEST_F(ResultsTest, the_table_of_runs_has_a_row_for_each_with_all_digits) {
  measure(1, "heuristic", kTime, {0.1, 1.0 / 3.0});
  at(1, "heuristic", 3).emplace().status = RunStatus::kFailed;
  const std::string table = runs_csv(plan, records);
  EXPECT_EQ(std::ranges::count(table, '\n'), 1 + 2 * 3 * 5);
  EXPECT_EQ(table.find("scenario,factor.seed,model,seed,status,person.travelTime,"), 0u);
  EXPECT_THAT(table, HasSubstr("\n\"town, \"\"old\"\"\",\"m,any\",heuristic,1,done,0.1,"));
  EXPECT_THAT(table, HasSubstr(",heuristic,2,done,0.3333333333333333,"));
  EXPECT_THAT(table, HasSubstr(",\"m,any\",heuristic,3,failed,,"));
  EXPECT_THAT(table, HasSubstr(",few,striping,1,missing,,"));
}

/// Fields of a line without quotes.
std::size_t fields(const std::string& table, std::size_t line) {
  std::size_t begin = 0;
  for (; line > 0; --line) begin = table.find('\n', begin) + 1;
  const std::string text = table.substr(begin, table.find('\n', begin) - begin);
  return static_cast<std::size_t>(std::ranges::count(text, ',')) + 1;
}

TEST_F(ResultsTest, the_summary_has_a_row_for_each_comparison_under_its_header) {
  plan.study.scenarios[0].id = "town";
  plan.study.factors[0].levels[1].name = "many";
  measure(0, "striping", kTime, {100, 120, 140, 160, 180});
  measure(0, "heuristic", kTime, {101, 122, 143, 164, 185});
  const auto comparisons = compare(plan, records);
  const std::string table = summary_csv(plan, comparisons);
  EXPECT_EQ(std::ranges::count(table, '\n'), 1 + static_cast<long>(comparisons.size()));
  for (const std::size_t line : {1u, 2u, 60u}) EXPECT_EQ(fields(table, line), fields(table, 0));
  EXPECT_THAT(table, HasSubstr("\ntown,few,heuristic,striping,person.travelTime,s,primary,5,0,0,"
                               "140,140,31.622776601683793,100,120,160,180,143,143,"));
  EXPECT_THAT(table, HasSubstr(",different,exact\n"));
  EXPECT_THAT(table, HasSubstr(",tooFew,exact\n"));
}

TEST_F(ResultsTest, the_JSON_holds_set_up_fairness_failures_and_comparisons) {
  plan.study.title = "\xff</script>";
  measure(0, "striping", kTime, {100, 120, 140, 160, 180});
  measure(0, "heuristic", kTime, {101, 122, 143, 164, 185});
  auto& failed = at(1, "orca", 4).emplace();
  failed.status = RunStatus::kFailed;
  failed.failure = "ran longer than 600 s\nlog's end";
  const auto summary = nlohmann::json::parse(
      summary_json(plan, records, compare(plan, records), free_speeds(plan, records)));
  EXPECT_EQ(summary["study"]["reference"], "striping");
  EXPECT_EQ(summary["study"]["factors"][0]["levels"][1], "m,any");
  EXPECT_EQ(summary["runs"]["done"], 10);
  EXPECT_EQ(summary["runs"]["planned"], 6 + 30);
  EXPECT_EQ(summary["freeSpeeds"].size(), 4u);
  EXPECT_TRUE(summary["freeSpeeds"][0]["ratio"].is_null());
  const auto& first = summary["comparisons"][0];
  EXPECT_EQ(first["difference"]["mean"], 3.0);
  EXPECT_EQ(first["levels"]["seed"], "few");
  EXPECT_EQ(first["finding"], "different");
  const auto is_failed = [](const auto& run) { return run["status"] == "failed"; };
  const auto& open = summary["runs"]["notDone"];
  const auto run = std::ranges::find_if(open, is_failed);
  ASSERT_NE(run, open.end());
  EXPECT_EQ((*run)["failure"], "ran longer than 600 s");
  EXPECT_EQ((*run)["seed"], 4);
}

}  // namespace
}  // namespace pedzone::study
