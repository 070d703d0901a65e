// A study as runs: which, in which order, and how they are named.
#include "study/plan/plan.hpp"

#include <regex>
#include <set>

#include "core/text.hpp"
#include "study_scene.hpp"

namespace pedzone::study {
namespace {

using ::testing::ElementsAre;
using ::testing::Eq;

class PlanTest : public StudyScene {
 protected:
  static std::set<std::string> ids(const Plan& plan) {
    std::set<std::string> ids;
    for (const PlannedRun& run : plan.runs) ids.insert(run.id);
    return ids;
  }

  static const PlannedRun& run(const Plan& plan, std::size_t condition, const std::string& model,
                               std::uint64_t seed, RunKind kind = RunKind::kStudy) {
    return plan.runs[plan.run_of(kind, condition, model, seed)];
  }

  const std::string plaza_ = scenario("plaza/plaza-low.sumocfg");
};

TEST_F(PlanTest, free_speed_first_then_by_seed_condition_model) {
  const Plan made = plan("<study seeds='4 9' models='orca striping'>" + plaza_ +
                         "<factor id='demand' sumo='scale' values='1 2'/></study>");
  std::vector<std::string> order;
  for (const PlannedRun& run : made.runs) {
    order.push_back((run.kind == RunKind::kFreeSpeed ? "free " : "") + std::to_string(run.seed) +
                    " " + made.conditions[run.condition].name + " " + run.model);
  }
  EXPECT_THAT(order,
              ElementsAre("free 4 plaza-low, demand=1 orca", "free 4 plaza-low, demand=1 striping",
                          "free 4 plaza-low, demand=2 orca", "free 4 plaza-low, demand=2 striping",
                          "4 plaza-low, demand=1 orca", "4 plaza-low, demand=1 striping",
                          "4 plaza-low, demand=2 orca", "4 plaza-low, demand=2 striping",
                          "9 plaza-low, demand=1 orca", "9 plaza-low, demand=1 striping",
                          "9 plaza-low, demand=2 orca", "9 plaza-low, demand=2 striping"));
}

TEST_F(PlanTest, every_run_is_found_again) {
  const Plan made = plan("<study seeds='1-3' models='orca striping plain'>" + plaza_ +
                         scenario("plaza/plaza-high.sumocfg") +
                         "<factor id='sight' parameter='sight' values='5 10'/></study>");
  for (std::size_t condition = 0; condition < made.conditions.size(); ++condition) {
    for (const std::string& model : made.study.models) {
      for (const std::uint64_t seed : made.study.seeds) {
        const PlannedRun& found = run(made, condition, model, seed);
        EXPECT_EQ(found.kind, RunKind::kStudy);
        EXPECT_EQ(found.model, model);
        EXPECT_EQ(found.seed, seed);
        EXPECT_EQ(found.definition.at("scenario"),
                  made.study.scenarios[made.conditions[condition].scenario].file);
        EXPECT_TRUE(model == kStriping || found.condition == condition);
        EXPECT_EQ(run(made, condition, model, seed, RunKind::kFreeSpeed).kind, RunKind::kFreeSpeed);
      }
    }
  }
  EXPECT_EQ(ids(made).size(), made.runs.size());
}

TEST_F(PlanTest, what_sumo_does_not_know_makes_no_run_more) {
  const Plan made = plan("<study seeds='1' models='striping nonInteracting heuristic'>" + plaza_ +
                         "<factor id='sight' parameter='sight' values='5 10'/>"
                         "<factor id='weather' zone='weather' values='fair rain'/></study>");
  // 4 conditions; SUMO's two models need one run for all of them.
  EXPECT_EQ(made.runs.size(), 2u * (4 + 2));
  for (const char* model : {kStriping, kNonInteracting}) {
    for (std::size_t condition = 0; condition < 4; ++condition) {
      EXPECT_EQ(run(made, condition, model, 1).id, run(made, 0, model, 1).id);
      EXPECT_EQ(run(made, condition, model, 1).condition, 0u);
    }
  }
}

TEST_F(PlanTest, what_decides_where_is_measured_makes_runs_for_all) {
  const Plan made = plan("<study seeds='1'>" + plaza_ +
                         "<factor id='space' zone='openSpace' values='0 10'/></study>");
  EXPECT_EQ(made.runs.size(), 2u * 4);
}

TEST_F(PlanTest, overlapping_seeds_have_the_same_ids) {
  const auto with_seeds = [&](const std::string& seeds) {
    return plan("<study seeds='" + seeds + "'>" + plaza_ +
                "<factor id='demand' sumo='scale' values='1 2'/></study>");
  };
  const Plan first = with_seeds("1-4"), second = with_seeds("3-6 9");
  for (const std::uint64_t seed : {3u, 4u}) {
    for (std::size_t condition = 0; condition < 2; ++condition) {
      for (const std::string& model : first.study.models) {
        const PlannedRun &a = run(first, condition, model, seed),
                         &b = run(second, condition, model, seed);
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.definition, b.definition);
      }
    }
  }
}

TEST_F(PlanTest, the_same_run_has_one_id_in_whatever_study) {
  const Plan plain = plan("<study seeds='7'>" + plaza_ + "</study>");
  const Plan other = plan(
      "<study id='x' title='y' seeds='5-9' models='orca heuristic' "
      "timeLimit='9'>" +
      scenario("plaza/plaza-high.sumocfg") +
      scenario("plaza/plaza-low.sumocfg", "id='other name'") +
      "<factor id='n'><level name='plain'/></factor></study>");
  EXPECT_EQ(run(plain, 0, "heuristic", 7).id, run(other, 1, "heuristic", 7).id);
  // The order in which factors set things decides nothing.
  const std::string a = "<factor id='a' sumo='scale' values='2'/>",
                    b = "<factor id='b' sumo='max-depart-delay' values='9'/>",
                    c = "<factor id='c' parameter='sight' values='5'/>";
  EXPECT_EQ(ids(plan("<study>" + plaza_ + a + b + c + "</study>")),
            ids(plan("<study>" + plaza_ + c + b + a + "</study>")));
}

TEST_F(PlanTest, whatever_decides_what_comes_out_changes_the_id) {
  const std::string zone = "<zones><zone id='a'/></zones>";
  write("a.zone.xml", zone);
  write("b.zone.xml", zone);
  const auto heuristic = [&](const std::string& attributes, const std::string& inside) {
    const Plan made = plan("<study seeds='1' " + attributes + ">" + inside + "</study>");
    return run(made, 0, made.study.models.back(), 1).id;
  };
  const std::set<std::string> different{
      heuristic("", plaza_),
      heuristic("models='striping orca'", plaza_),
      heuristic("end='50'", plaza_),
      heuristic("end='50.5'", plaza_),
      heuristic("", scenario("plaza/plaza-high.sumocfg")),
      heuristic("", scenario("plaza/plaza-low.sumocfg", "zone='a.zone.xml'")),
      heuristic("", scenario("plaza/plaza-low.sumocfg", "zone='b.zone.xml'")),
      heuristic("", scenario("plaza/plaza-low.sumocfg", "options='--scale 2'")),
      heuristic("", plaza_ + "<factor id='a' sumo='scale' values='3'/>"),
      heuristic("", plaza_ + "<factor id='a' panel='number' values='3'/>"),
      heuristic("", plaza_ + "<factor id='a' zone='openSpace' values='3'/>"),
      heuristic("", plaza_ + "<factor id='a' zone='weather' values='ice'/>"),
      heuristic("", plaza_ + "<factor id='a' parameter='sight' values='3'/>")};
  EXPECT_EQ(different.size(), 13u);
}

TEST_F(PlanTest, hostile_names_make_safe_ids) {
  const std::regex safe("[A-Za-z0-9_][A-Za-z0-9._-]{0,99}");
  const std::string config = "<configuration><net-file value='" PEDZONE_SCENARIOS
                             "/../networks/plaza/plaza.net.xml'/>"
                             "<route-files value='" PEDZONE_SCENARIOS
                             "/plaza/plaza-low.persons.rou.xml'/><end value='9'/>"
                             "</configuration>";
  std::set<std::string> seen;
  for (const std::string& name :
       {std::string("..sumocfg"), std::string(".hidden.sumocfg"), std::string("-rf.sumocfg"),
        std::string("a b;$(x)`y`.sumocfg"), std::string("<script>.sumocfg"),
        std::string("\"quote'.sumocfg"), std::string("\xC3\xBC\xF0\x9F\x9A\xB6.sumocfg"),
        std::string("new\nline.sumocfg"), std::string(200, 'x') + ".sumocfg",
        std::string(200, 'x') + "y.sumocfg", std::string("CON"), std::string("a.b.sumocfg")}) {
    write(name, config);
    const std::string file = xml_value(name);
    for (const PlannedRun& run : plan("<study seeds='1'><scenario file=\"" + file +
                                      "\" id=\"id of " + file + "\"/></study>")
                                     .runs) {
      EXPECT_TRUE(std::regex_match(run.id, safe)) << run.id;
      EXPECT_TRUE(seen.insert(run.id).second) << run.id;
    }
  }
}

TEST_F(PlanTest, settings_of_a_scenario_stay_there) {
  const Plan made = plan("<study seeds='1'>" + plaza_ + scenario("plaza/plaza-high.sumocfg") +
                         "<factor id='demand'><level name='low'/><level name='high'>"
                         "<set sumo='scale' value='2' scenario='plaza-high'/>"
                         "<set panel='number' value='9' scenario='plaza-low'/></level></factor>"
                         "</study>");
  const auto definition = [&](std::size_t condition) {
    return run(made, condition, "heuristic", 1).definition;
  };
  ASSERT_THAT(made.conditions[1].name, Eq("plaza-low, demand=high"));
  EXPECT_EQ(definition(1).at("panel").dump(), "{\"number\":\"9\"}");
  EXPECT_EQ(definition(1).at("sumo").dump(), "{}");
  ASSERT_THAT(made.conditions[3].name, Eq("plaza-high, demand=high"));
  EXPECT_EQ(definition(3).at("sumo").dump(), "{\"scale\":\"2\"}");
  EXPECT_FALSE(definition(3).contains("panel"));
}

}  // namespace
}  // namespace pedzone::study
