// The choice of a direction by Eq. 1 and Eq. 2.
#include <gtest/gtest.h>

#include <algorithm>

#include "oracle.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kDegree = kPi / 180.0;

double degrees_off_heading(const Scene& scene) {
  return std::abs(wrap_angle(scene.first().direction - scene.people[0].heading)) / kDegree;
}

TEST(Direction, leads_straight_to_the_goal_where_nothing_is_in_the_way) {
  Scene scene;
  scene.people = {walking_to({0, 0}, 0.0)};
  const Decision d = scene.first();
  EXPECT_EQ(d.direction, 0.0);
  EXPECT_EQ(d.speed, 1.34);
  EXPECT_NEAR(d.free_distance, 10.0, 1e-5);
  EXPECT_FALSE(d.waits);
}

TEST(Direction, is_the_candidate_nearest_to_the_goal_in_free_space) {
  for (const int equation : {1, 2}) {
    for (double goal = -170.0; goal <= 170.0; goal += 13.7) {
      Scene scene;
      scene.parameters.equation = equation;
      scene.people = {walking_to({0, 0}, 0.5)};
      scene.people[0].goal = 0.5 + goal * kDegree;
      const double off = wrap_angle(scene.first().direction - 0.5 - goal * kDegree) / kDegree;
      EXPECT_LE(std::abs(off), (std::abs(goal) < 75.0 ? 1.25 : 2.5) + 1e-6) << goal;
    }
  }
}

/// A person 1 m (body's edge) before a long wall that faces it.
Scene before_a_wall(int equation) {
  Scene scene;
  scene.model_name = "plain";
  scene.parameters.equation = equation;
  scene.parameters.candidate_field = 90.0;  // every 3°
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.walls = {{{1.24, -60.0}, {1.24, 60.0}}};
  return scene;
}

TEST(Direction, before_a_long_wall_stays_straight_by_eq_1) {
  const Scene scene = before_a_wall(1);
  EXPECT_EQ(degrees_off_heading(scene), 0.0);
  EXPECT_NEAR(scene.first().free_distance, 1.0, 1e-3);
}

TEST(Direction, before_a_long_wall_turns_along_it_by_eq_2) {
  // Where f = 1/cos α, on a fine grid.
  double best = 0.0, least = 1e300;
  for (double a = 0.0; a < 90.0; a += 0.01) {
    const double d = value(2, std::min(1.0 / std::cos(a * kDegree), 10.0), 10.0, a * kDegree);
    if (d < least) {
      least = d;
      best = a;
    }
  }
  EXPECT_NEAR(best, 82.0, 1.0);
  EXPECT_NEAR(degrees_off_heading(before_a_wall(2)), best, 1.5);
}

/// A person in the middle of a ring of walls, its body's edge 1 m from them, with one gap.
Scene in_a_ring(int equation, double gap_degrees) {
  constexpr double kRadius = 0.02, kHalfGap = 2.0;
  Scene scene;
  scene.model_name = "plain";
  scene.parameters.equation = equation;
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.people[0].radius = kRadius;
  for (double a = gap_degrees + kHalfGap; a < gap_degrees + 360.0 - kHalfGap - 0.5; a += 1.0) {
    const double to = std::min(a + 1.0, gap_degrees + 360.0 - kHalfGap);
    scene.walls.push_back(
        {(1.0 + kRadius) * unit(a * kDegree), (1.0 + kRadius) * unit(to * kDegree)});
  }
  return scene;
}

TEST(Direction, a_free_one_is_taken_up_to_53_5_degrees_by_eq_1) {
  // cos α > 0.595: 1 − 20 = 100 − 200 cos α at the border, 53.5°.
  EXPECT_NEAR(degrees_off_heading(in_a_ring(1, 52.5)), 52.5, 1e-6);
  EXPECT_NEAR(degrees_off_heading(in_a_ring(1, -52.5)), 52.5, 1e-6);
  EXPECT_EQ(degrees_off_heading(in_a_ring(1, 55.0)), 0.0);
}

TEST(Direction, a_free_one_is_taken_up_to_107_degrees_by_eq_2) {
  EXPECT_NEAR(degrees_off_heading(in_a_ring(2, 105.0)), 105.0, 1e-5);
  EXPECT_NEAR(degrees_off_heading(in_a_ring(2, -105.0)), 105.0, 1e-5);
  EXPECT_EQ(degrees_off_heading(in_a_ring(2, 110.0)), 0.0);
}

TEST(Direction, the_whole_circle_is_searched_only_where_the_best_is_blocked_near_by) {
  Scene scene = in_a_ring(2, 105.0);
  scene.parameters.near_distance = 0.5;  // what blocks is 1 m away: far
  EXPECT_LE(degrees_off_heading(scene), 75.0);
}

TEST(Direction, a_blocked_person_turns_round) {
  Scene scene;  // a dead end: walls ahead and on both sides, 0.5 m from the body
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.people[0].goal = kPi;
  scene.walls = {
      {{-5, -0.74}, {0.74, -0.74}}, {{0.74, -0.74}, {0.74, 0.74}}, {{0.74, 0.74}, {-5, 0.74}}};
  EXPECT_NEAR(degrees_off_heading(scene), 180.0, 1e-6);
}

/// In a random scene every four walls are an obstacle, their walkable side outside.
bool inside_an_obstacle(const Scene& scene, const Vec2& at) {
  for (std::size_t first = 0; first < scene.walls.size(); first += 4) {
    int behind = 0;
    for (std::size_t w = first; w < first + 4; ++w) {
      const Wall& wall = scene.walls[w];
      behind += cross(wall.b - wall.a, at - wall.a) < 0.0 ? 1 : 0;
    }
    if (behind == 4) return true;
  }
  return false;
}

/// Whether the person touches something, for which there are rules of its own, or nearly does.
bool touches(const Scene& scene, std::size_t person) {
  const Vec2& at = scene.people[person].at;
  if (inside_an_obstacle(scene, at)) return true;
  return std::ranges::any_of(aware_of(scene, person), [&](const Obstacle& o) {
    // A contact is softened from 1/√(1 − 0.2) times its distance on.
    const double margin = o.kind == Obstacle::Kind::kDisc ? 0.23 * o.contact + 0.02 : 0.02;
    return o.distance(at, 0.0) < o.contact + margin;
  });
}

struct OracleCase {
  const char *name, *model;
  double equation;
};

class Oracle : public testing::TestWithParam<OracleCase> {};

TEST_P(Oracle, is_agreed_with_in_random_scenes) {
  int compared = 0, turned = 0, queueing = 0;
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    const double density = seed % 2 == 0 ? 0.15 : 0.6;
    Scene scene = random_scene({.people = 25, .density = density, .obstacles = 2}, seed);
    scene.model_name = GetParam().model;
    scene.parameters.equation = GetParam().equation;
    for (PersonSpec& p : scene.people) {
      p.goal_distance = 1000.0;
      p.goal = p.heading + 0.4 * (p.goal > p.heading ? 1.0 : -1.0);
    }
    const std::vector<Decision> decisions = scene.decide();
    for (std::size_t i = 0; i < scene.people.size(); ++i) {
      if (touches(scene, i)) continue;
      const OracleDecision expected = decision_of(scene, i);
      // A margin of less is too close to tell: 5 mm of free way.
      if (!expected.clear || expected.choice.margin < 0.2) continue;
      const Decision& d = decisions[i];
      const PersonSpec& person = scene.people[i];
      const double off = wrap_angle(d.direction - person.heading);
      EXPECT_NEAR(off, wrap_angle(expected.choice.offset), 1e-6) << "seed " << seed << " of " << i;
      EXPECT_NEAR(d.free_distance, expected.free, 0.02) << "seed " << seed << " of " << i;
      EXPECT_NEAR(d.speed, std::min(person.speed, expected.free / 0.5), 0.02 / 0.5);
      EXPECT_EQ(d.turns, expected.turns) << "seed " << seed << " of " << i;
      ++compared;
      turned += expected.turns ? 1 : 0;
      queueing += expected.free < expected.choice.free - 0.05 ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 250);
  EXPECT_GT(turned, 10);
  EXPECT_GT(queueing, 5);
}

INSTANTIATE_TEST_SUITE_P(Models, Oracle,
                         testing::Values(OracleCase{"plain_eq_1", "plain", 1.0},
                                         OracleCase{"plain_eq_2", "plain", 2.0},
                                         OracleCase{"heuristic", "heuristic", 2.0},
                                         OracleCase{"original", "heuristic-original", 2.0}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Direction, ignores_what_stands_behind_the_goal) {
  Scene scene;
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.people[0].goal_distance = 3.0;
  scene.walls = {{{4.0, -30.0}, {4.0, 30.0}}};
  PersonSpec standing;
  standing.at = {4.4, 0.1};
  scene.people.push_back(standing);
  scene.vehicles = {vehicle({6.5, 0.0}, kPi / 2, 0.0)};
  EXPECT_EQ(degrees_off_heading(scene), 0.0);
  EXPECT_EQ(scene.first().speed, 1.34);
}

TEST(Direction, avoids_what_stands_before_the_goal) {
  Scene scene;
  scene.people = {walking_to({0, 0}, 0.0)};
  PersonSpec standing;
  standing.at = {2.0, 0.05};
  scene.people.push_back(standing);
  scene.people[0].goal_distance = 3.0;
  EXPECT_GT(degrees_off_heading(scene), 5.0);
}

TEST(Direction, a_wall_behind_the_goal_still_slows_a_person_that_would_run_into_it) {
  Scene scene;
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.people[0].goal_distance = 0.05;
  scene.walls = {{{0.44, -30.0}, {0.44, 30.0}}};
  const Decision d = scene.first();
  EXPECT_LE(d.speed * std::cos(d.direction) * scene.parameters.collision_time, 0.2 + 1e-3);
}

TEST(Direction, somebody_who_touches_counts_only_for_directions_that_lead_closer) {
  Scene scene;
  scene.model_name = "plain";  // by Eq. 1 nobody turns aside so far
  scene.people = {walking_to({0, 0}, 0.0), walking_to({0.47, 0.0}, kPi / 2)};
  scene.people[1].velocity = Vec2::Zero();
  for (PersonSpec& p : scene.people) p.turned_width = 1.0;  // or they would not touch
  scene.people[0].goal = kPi / 2;                           // sideways: neither closer nor farther
  Decision d = scene.first();
  EXPECT_NEAR(d.direction, kPi / 2, 2.6 * kDegree);
  EXPECT_EQ(d.speed, 1.34);
  scene.people[0].goal = 0.0;  // straight into it
  d = scene.first();
  EXPECT_GT(std::abs(d.direction), 60.0 * kDegree);
}

TEST(Direction, a_person_that_touches_a_wall_walks_along_it) {
  for (const double overlap : {-0.005, 0.0, 0.05}) {
    Scene scene;
    scene.people = {walking_to({0, 0}, 0.0)};
    const double y = -0.24 + overlap;  // a wall of many pieces along its right side
    for (int i = -20; i < 40; ++i) scene.walls.push_back({{i * 0.5, y}, {i * 0.5 + 0.5, y}});
    const Decision d = scene.first();
    EXPECT_EQ(d.direction, 0.0) << overlap;
    EXPECT_EQ(d.speed, 1.34) << overlap;
  }
}

TEST(Direction, a_person_outside_the_walkable_area_can_come_back) {
  Scene scene;  // inside a square whose walkable side is outside
  scene.people = {walking_to({0, 0}, 0.3)};
  scene.walls = {{{-1, -1}, {-1, 1}}, {{-1, 1}, {1, 1}}, {{1, 1}, {1, -1}}, {{1, -1}, {-1, -1}}};
  const Decision d = scene.first();
  EXPECT_EQ(d.direction, 0.3);
  EXPECT_EQ(d.speed, 1.34);
}

TEST(Direction, somebody_pressed_on_from_all_sides_faces_its_goal_and_stands) {
  Scene scene;
  scene.people = {walking_to({0, 0}, 0.3)};
  scene.people[0].goal = 0.3;
  for (int i = 0; i < 12; ++i) {
    PersonSpec other;
    other.at = 0.45 * unit(i * kPi / 6);
    scene.people.push_back(other);
  }
  scene.parameters.field_of_view = 180.0;
  const Decision d = scene.first();
  EXPECT_NEAR(wrap_angle(d.direction - 0.3), 0.0, 20.0 * kDegree);
  EXPECT_LT(d.speed, 0.1);
}

TEST(Speed, follows_eq_3) {
  for (const double gap : {0.1, 0.3, 0.5, 0.66, 0.68, 1.5}) {
    for (const double collision_time : {0.3, 0.5, 2.0}) {
      Scene scene;
      scene.parameters.equation = 1.0;
      scene.parameters.collision_time = collision_time;
      scene.people = {walking_to({0, 0}, 0.0)};
      scene.walls = {{{0.24 + gap, -60.0}, {0.24 + gap, 60.0}}};
      const Decision d = scene.first();
      EXPECT_NEAR(d.speed, std::min(1.34, d.free_distance / collision_time), 1e-9);
      if (d.direction == 0.0) {
        EXPECT_NEAR(d.free_distance, gap, 1e-3);
      }
    }
  }
}

}  // namespace
}  // namespace pedzone::test
