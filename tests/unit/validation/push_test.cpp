// What vehicles do to people in a replay, and what people would have done without it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "validation/calibration.hpp"

namespace pedzone::test {
namespace {

/// Somebody who walks east at 1.2 m/s for 8 s, and one far away; a vehicle of 4 by 2 m drives west
/// towards the first at `speed` [m/s], `aside` [m] beside its line. In the recording both pass
/// 30 m apart.
Clip clip(double speed, double aside, const std::string& name = "a") {
  Clip clip{name, "site", "front", {}, {}};
  for (const double y : {0.0, 40.0}) {
    PersonTrack track{"p" + std::to_string(static_cast<int>(y)), 0, {}};
    for (int k = 0; k <= 80; ++k) track.places.emplace_back(0.12 * k, y);
    clip.persons.push_back(std::move(track));
  }
  VehicleTrack vehicle{"v", 0, {}};
  for (int k = 0; k <= 80; ++k) {
    VehicleState state;
    state.centre = {5.0 + 4.0 * speed - 0.1 * speed * k, aside};
    state.heading = M_PI;
    state.velocity = {-speed, 0.0};
    state.length = 4.0;
    state.width = 2.0;
    vehicle.states.push_back(state);
  }
  clip.vehicles.push_back(std::move(vehicle));
  return clip;
}

ReplayModel model(const std::string& name) {
  ReplayModel model;
  model.name = model.model = name;
  return model;
}

double value(const Figures& figures, Figure figure) {
  return figures[static_cast<std::size_t>(figure)];
}

Figures figures(const ScoredRuns& runs) {
  std::vector<const ScoredPerson*> persons;
  for (const ScoredPerson& person : runs.front()) persons.push_back(&person);
  return figures_of(persons);
}

TEST(ReplayedPush, tells_who_is_pushed_and_where_it_would_have_been) {
  const Clip one = clip(1.0, 0.3);
  const Replayed replayed = replay(one, model("constant-velocity"), 0);
  ASSERT_EQ(replayed.pushes.size(), 2u);
  const Measures pushed = measure(one, VehicleWays(one), 0, replayed),
                 alone = measure(one, VehicleWays(one), 1, replayed);
  EXPECT_GT(pushed.push->way, 1.0);
  EXPECT_LE(pushed.push->speed, 3.0 + 1e-9);
  EXPECT_TRUE(pushed.push->run_into) << "it is moved along by more than a step";
  EXPECT_GT(pushed.clearance, 0.24) << "bodies are kept apart";
  EXPECT_LT(pushed.unpushed, -0.3) << "the model would have walked into it";
  EXPECT_EQ(alone.push->way, 0.0);
  EXPECT_EQ(alone.unpushed, alone.clearance);
}

TEST(ReplayedPush, of_a_fast_vehicle_runs_into_who_does_not_make_way) {
  const Clip one = clip(6.0, 0.3);
  const Measures hit =
      measure(one, VehicleWays(one), 0, replay(one, model("constant-velocity"), 0));
  EXPECT_TRUE(hit.push->run_into);
  EXPECT_NEAR(hit.push->speed, 3.0, 1e-9);
  EXPECT_LT(hit.clearance, 0.24);
}

TEST(ReplayedPush, is_none_where_people_make_way_by_themselves) {
  const Clip one = clip(1.0, 0.3);
  const Replayed replayed = replay(one, model("heuristic"), 0);
  EXPECT_EQ(replayed.pushes[0].way, 0.0);
  EXPECT_EQ(replayed.ways[0], replayed.unpushed[0]);
  EXPECT_GT(measure(one, VehicleWays(one), 0, replayed).unpushed, 0.25);
}

TEST(PushFigures, tell_what_the_guard_hides) {
  const Figures walked = figures(score({clip(1.0, 0.3)}, model("constant-velocity"), 1));
  EXPECT_DOUBLE_EQ(value(walked, Figure::kInside), 0.5);
  EXPECT_DOUBLE_EQ(value(walked, Figure::kClose), 0.5);
  EXPECT_DOUBLE_EQ(value(walked, Figure::kPushed), 0.5);
  EXPECT_GT(value(walked, Figure::kPushWay), 1.0);
  for (const double speed : {1.0, 6.0}) {
    EXPECT_DOUBLE_EQ(
        value(figures(score({clip(speed, 0.3)}, model("constant-velocity"), 1)), Figure::kRunInto),
        0.5);
  }
}

TEST(PushFigures, are_none_where_no_crowd_walks) {
  ReplayModel blind;
  blind.kind = ReplayModel::Kind::kStraight;
  const Figures walked = figures(score({clip(1.0, 0.3)}, blind, 1));
  EXPECT_DOUBLE_EQ(value(walked, Figure::kInside), 0.5);
  for (const Figure figure :
       {Figure::kPushed, Figure::kPushWay, Figure::kPushSpeed, Figure::kRunInto}) {
    EXPECT_TRUE(std::isnan(value(walked, figure)));
  }
}

TEST(PushFigures, have_the_longest_push_of_all_seeds) {
  const ValidationResult result =
      validate({clip(1.0, 0.3, "a"), clip(1.0, 0.5, "b"), clip(1.0, 0.4, "c"), clip(1.0, 0.6, "d"),
                clip(1.0, 0.2, "e")},
               {{model("constant-velocity")}, 4, 20, false}, [](double) {});
  double longest = 0.0, mean = 0.0;
  for (const auto& run : result.runs.front()) {
    double of_seed = 0.0;
    for (const ScoredPerson& person : run) of_seed = std::max(of_seed, person.walked.push->way);
    longest = std::max(longest, of_seed);
    mean += of_seed / 4.0;
  }
  ASSERT_LT(mean, longest - 1e-6) << "speeds vary from seed to seed";
  const auto row = std::ranges::find(result.rows, "constant-velocity", &ValidationRow::model);
  const auto way = static_cast<std::size_t>(Figure::kPushWay);
  EXPECT_DOUBLE_EQ(row->value[way], longest);
  EXPECT_TRUE(std::isnan(row->low[way])) << "a greatest value has no interval by bootstrap";
  EXPECT_FALSE(std::isnan(row->high[static_cast<std::size_t>(Figure::kPushed)]));
}

TEST(Misfit, counts_pushes_and_who_would_come_too_near) {
  const std::vector<Clip> clips{clip(1.0, 2.0)};
  const std::vector<bool> used{true};
  ScoredRuns runs = score(clips, model("heuristic"), 1);
  ASSERT_EQ(runs[0][0].walked.push->way, 0.0);
  const double before = misfit(clips, runs, used);
  runs[0][0].walked.push->way = 0.3;
  const double with_push = misfit(clips, runs, used);
  EXPECT_GT(with_push, before + 1.0);
  runs[0][0].walked.unpushed = 0.1;
  EXPECT_GT(misfit(clips, runs, used), with_push + 1.0);
}

}  // namespace
}  // namespace pedzone::test
