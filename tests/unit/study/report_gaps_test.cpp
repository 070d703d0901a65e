// What the report tells of gaps: those of all runs of a condition and model, from their tables.
#include <cmath>

#include "results/crossing_table.hpp"
#include "study/measure/run_measures.hpp"
#include "study/measure/street_crossings.hpp"
#include "study/report/report_parts.hpp"
#include "study_scene.hpp"

namespace pedzone::study {
namespace {

using report::Json;

SeenCrossing crossing(std::optional<double> gap, std::vector<double> let_pass,
                      bool between = true) {
  return {.person = "<b>&", .between = between, .gap = gap, .let_pass = std::move(let_pass)};
}

class ReportedGaps : public StudyScene {
 protected:
  ReportedGaps() : records_(plan_.runs.size()) {
    for (std::size_t k = 0; k < plan_.runs.size(); ++k) {
      records_[k].emplace();
      records_[k]->id = plan_.runs[k].id;
    }
  }

  void seen(const std::string& model, std::uint64_t seed,
            const std::vector<SeenCrossing>& crossings) const {
    const std::string id = plan_.runs[run(model, seed)].id;
    std::filesystem::create_directories(store_.run_folder(id));
    std::ofstream(store_.run_folder(id) + "/" + kCrossings) << crossings_csv(crossings);
  }
  std::size_t run(const std::string& model, std::uint64_t seed) const {
    return plan_.run_of(RunKind::kStudy, 0, model, seed);
  }
  report::Input input() const { return {store_, plan_, records_, {}, {}}; }

  const Plan plan_ = plan("<study id=\"s\" seeds=\"1-3\" models=\"striping heuristic\">" +
                          scenario("plaza/plaza-low.sumocfg") + "</study>");
  const Store store_ = Store::create(folder_ + "/results", plan_.study, {});
  Records records_;
};

TEST_F(ReportedGaps, are_those_of_all_seeds_between_the_junctions) {
  seen("striping", 1, {crossing(4.0, {3.0}, false)});
  seen("heuristic", 1, {crossing(5.5, {2.5, 2.25}), crossing(9.0, {}, false)});
  seen("heuristic", 2, {crossing(2.0, {}), crossing({}, {5.75})});
  seen("heuristic", 3, {crossing(7.0, {})});
  records_[run("heuristic", 3)]->status = RunStatus::kFailed;
  const Json groups = report::gaps(input());
  ASSERT_EQ(groups.size(), 1U) << groups;
  EXPECT_EQ(groups[0]["c"], 0);
  EXPECT_EQ(groups[0]["m"], 1);
  EXPECT_EQ(groups[0]["taken"], 2);
  EXPECT_EQ(groups[0]["left"], 3);
  EXPECT_EQ(groups[0]["counted"], Json::parse("[[2.5, 0.33333, 3], [5.5, 0.5, 2]]"));
  EXPECT_FALSE(groups[0].contains("median"));  // too few
  const Json table = report::gaps_part(input(), groups);
  EXPECT_EQ(table["rows"][0]["model"], "heuristic");
  EXPECT_EQ(table["rows"][0]["median"], "–");
}

TEST_F(ReportedGaps, have_the_curve_and_the_median_of_all_together) {
  // At 4 s as at 6 s one of four is on the other side: the median lies between, alike from both.
  seen("heuristic", 1, {crossing(6.0, {4.0, 4.0, 4.0}), crossing(6.0, {6.0}), crossing(6.0, {})});
  seen("heuristic", 2,
       {crossing(4.0, {4.0, 4.0, 4.0}), crossing(6.0, {6.0}), crossing(6.0, {}), crossing(6.0, {}),
        crossing(4.0, {})});
  const Json groups = report::gaps(input());
  ASSERT_EQ(groups.size(), 1U) << groups;
  const Json& one = groups[0];
  EXPECT_EQ(one["counted"], Json::parse("[[4.5, 0.25, 8], [6.5, 0.75, 8]]"));
  // The regression goes through both shares: logit(3/4) = ln 3 = slope * 1 s.
  EXPECT_EQ(one["median"], 5.0);
  EXPECT_EQ(one["curve"][8], Json::parse("[4.0, 0.25]"));
  EXPECT_EQ(one["curve"][12], Json::parse("[6.0, 0.75]"));
  EXPECT_EQ(one["curve"].back()[0], 20.0);
  // Variance of the intercept at the median: 1 / (16 * 3/16); over the slope.
  const double half = 1.959964 / std::sqrt(3.0) / std::log(3.0);
  EXPECT_NEAR(one["interval"][0], 5.0 - half, 1e-4);
  EXPECT_NEAR(one["interval"][1], 5.0 + half, 1e-4);
  EXPECT_EQ(report::gaps_part(input(), groups)["rows"][0]["median"], "5.0 [4.0, 6.0]");
}

TEST_F(ReportedGaps, have_no_curve_where_one_gap_parts_them) {
  seen("heuristic", 1,
       {crossing(6.0, {3.0, 2.0, 2.5}), crossing(5.0, {1.0}), crossing(7.0, {1.5}),
        crossing(5.5, {}), crossing(8.0, {})});
  const Json groups = report::gaps(input());
  ASSERT_EQ(groups.size(), 1U) << groups;
  EXPECT_EQ(groups[0]["median"], 4.0);
  EXPECT_FALSE(groups[0].contains("curve"));
  EXPECT_FALSE(groups[0].contains("interval"));
  EXPECT_EQ(report::gaps_part(input(), groups)["rows"][0]["median"], "4.0");
}

TEST_F(ReportedGaps, are_none_where_no_street_may_be_crossed_anywhere) {
  const Json groups = report::gaps(input());
  EXPECT_TRUE(groups.empty());
  EXPECT_EQ(report::gaps_part(input(), groups), Json(false));
}

}  // namespace
}  // namespace pedzone::study
