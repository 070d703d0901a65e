// One person alone: it keeps its speed, its way and its walls.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene.hpp"

namespace pedzone::test {
namespace {

// The limit for the free speed against SUMO's.
constexpr double kFreeSpeedTolerance = 0.02;
// What the contact of a body with a wall may be off by, numerically.
constexpr double kTouch = 1e-6;

double length_of(const std::vector<Vec2>& path) {
  double length = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k) length += (path[k] - path[k - 1]).norm();
  return length;
}

TEST(Walking, reaches_a_portal_straight_and_on_time) {
  const Zone zone = zone_of(box(0, 0, 60, 10));
  Scene scene(zone);
  const auto person = scene.add({2, 5}, line_at_x(58, 0, 10));
  scene.run(120);
  ASSERT_EQ(scene.arrived(), 1u);
  const auto& p = scene.people[person];
  EXPECT_FALSE(p.view.gave_up);
  EXPECT_NEAR(p.walked / p.arrival_time, 1.34, kFreeSpeedTolerance * 1.34);
  for (const Vec2& place : p.path) EXPECT_NEAR(place.y(), 5.0, 0.05);
}

TEST(Walking, from_standing_loses_only_the_start) {
  const Zone zone = zone_of(box(0, 0, 110, 10));
  Scene scene(zone);
  const auto person = scene.add({2, 5}, line_at_x(108, 0, 10), 1.34, 0.0);
  scene.run(120);
  const auto& p = scene.people[person];
  // v(t) = v0 (1 - exp(-t / tau)) lags by tau, here 0.5 s; one step of resolution.
  EXPECT_NEAR(p.arrival_time, p.walked / 1.34 + 0.5, 0.11);
}

TEST(Walking, keeps_its_speed_with_the_heading_noise_on) {
  const Zone zone = zone_of(box(0, 0, 210, 20), {}, true);
  double slowest = 1.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Scene scene(zone, seed);
    const auto person = scene.add({2, 10}, line_at_x(208, 0, 20));
    scene.run(250);
    ASSERT_EQ(scene.arrived(), 1u);
    const double beeline = scene.people[person].path.back().x() - 2.0;
    slowest = std::min(slowest, beeline / scene.people[person].arrival_time / 1.34);
  }
  EXPECT_GT(slowest, 0.995);  // "not more than a fraction of a percent", along the beeline
}

TEST(Walking, noise_makes_ways_differ_between_seeds_and_repeats_with_one) {
  const Zone zone = zone_of(box(0, 0, 60, 20), {}, true);
  std::vector<std::vector<Vec2>> paths;
  for (const std::uint64_t seed : {1, 1, 2}) {
    Scene scene(zone, seed);
    scene.add({2, 10}, line_at_x(58, 0, 20));
    scene.run(60);
    paths.push_back(scene.people[0].path);
  }
  EXPECT_EQ(paths[0], paths[1]);
  EXPECT_NE(paths[0], paths[2]);
}

class BendingWay : public ::testing::TestWithParam<double> {};

// A street with four right angles, 3 m wide: nobody leaves it, and the bends cost little.
TEST_P(BendingWay, is_walked_inside_and_at_free_speed) {
  const double step = GetParam();
  const Region street = unite(unite(repair(box(0, 0, 20, 3)), repair(box(17, 0, 20, 23))),
                              unite(repair(box(17, 20, 40, 23)), repair(box(37, 0, 40, 23))));
  const Zone zone = zone_of(street, {}, true);
  Scene scene(zone);
  const auto person = scene.add({1, 1.5}, line_at_y(1, 37, 40));
  while (scene.time < 120 && scene.arrived() == 0) scene.step(step);
  ASSERT_EQ(scene.arrived(), 1u);
  EXPECT_GE(scene.least_wall_gap(), -kTouch);
  const auto& p = scene.people[person];
  EXPECT_NEAR(p.walked / p.arrival_time, 1.34, kFreeSpeedTolerance * 1.34 + 1.34 * step / 70);
  // Taut round the inner corners at the clearance of ways, or at least nearly so.
  EXPECT_LT(length_of(p.path), 1.03 * zone.ways.distance({1, 1.5}, {38.5, 1}));
}

INSTANTIATE_TEST_SUITE_P(Steps, BendingWay, ::testing::Values(0.1, 0.5, 1.0));

TEST(Walking, passes_a_gap_of_one_metre) {
  const Zone zone = zone_of(box(0, 0, 20, 10), {box(9.5, -1, 10.5, 6), box(9.5, 7, 10.5, 11)});
  Scene scene(zone);
  scene.add({2, 2}, line_at_x(18, 0, 10));
  scene.run(40);
  EXPECT_EQ(scene.arrived(), 1u);
  EXPECT_GE(scene.least_wall_gap(), -kTouch);
}

TEST(Walking, uses_the_whole_width_of_a_portal) {
  const Zone zone = zone_of(box(0, 0, 40, 20));
  Scene scene(zone);
  for (double y = 2; y < 19; y += 2) {
    NewPerson person;
    person.position = {5, y};
    person.velocity = {1.34, 0};
    person.destination = line_at_x(38, 0, 20);
    scene.add(person);
  }
  scene.run(60);
  ASSERT_EQ(scene.arrived(), scene.people.size());
  for (const auto& p : scene.people) EXPECT_NEAR(p.path.back().y(), p.path.front().y(), 0.3);
}

TEST(Walking, reaches_a_portal_on_the_border_itself) {
  const Zone zone = zone_of(box(0, 0, 40, 20));
  Scene scene(zone);
  const auto person = scene.add({5, 10}, line_at_x(40, 0, 20));
  scene.run(60);
  ASSERT_EQ(scene.arrived(), 1u);
  EXPECT_LT(scene.people[person].arrival_time, 35 / 1.34 + 1.5);
  EXPECT_FALSE(scene.people[person].view.gave_up);
}

TEST(Walking, arrives_at_the_nearest_place_when_the_destination_lies_outside) {
  const Zone zone = zone_of(box(0, 0, 40, 20));
  Scene scene(zone);
  scene.add({5, 10}, point(60, 10));
  scene.add({5, 14}, line_at_x(45, 8, 16));
  scene.run(60);
  ASSERT_EQ(scene.arrived(), 2u);
  for (const auto& p : scene.people) EXPECT_GT(p.path.back().x(), 39.0);
}

TEST(Walking, goes_on_without_a_way_and_never_fails) {
  // Two islands: there is none from one to the other.
  Region islands = repair(box(0, 0, 10, 10));
  islands = unite(islands, repair(box(20, 0, 30, 10)));
  const Zone zone = zone_of(islands);
  Scene scene(zone);
  const auto person = scene.add({5, 5}, point(25, 5));
  scene.run(60);
  EXPECT_EQ(scene.arrived(), 0u);
  EXPECT_TRUE(zone.walls.inside(scene.people[person].view.position));
  EXPECT_GT(scene.people[person].view.position.x(), 9.0);
}

TEST(Walking, takes_the_nearer_end_of_a_portal_behind_a_house) {
  //  start ┌───────┐ ║  The middle of the portal is hidden; its lower end is the shorter way.
  //   ●    │ house │ ║
  //        └───────┘ ║
  const Zone zone = zone_of(box(0, 0, 40, 40), {box(10, 5, 30, 39)});
  Scene scene(zone);
  const auto person = scene.add({5, 12}, line_at_x(35, 1, 39));
  scene.run(60);
  ASSERT_EQ(scene.arrived(), 1u);
  EXPECT_LT(scene.people[person].path.back().y(), 6.0);
}

TEST(Walking, a_changed_destination_turns_it_round) {
  const Zone zone = zone_of(box(0, 0, 40, 10));
  Scene scene(zone);
  const auto person = scene.add({20, 5}, line_at_x(39, 0, 10));
  scene.run(5);
  scene.crowd.set_destination(scene.people[person].handle, line_at_x(1, 0, 10));
  scene.run(60);
  ASSERT_EQ(scene.arrived(), 1u);
  EXPECT_LT(scene.people[person].path.back().x(), 1.5);
}

TEST(Walking, a_changed_preferred_speed_is_kept_to) {
  const Zone zone = zone_of(box(0, 0, 60, 10));
  Scene scene(zone);
  const auto person = scene.add({5, 5}, line_at_x(59, 0, 10), 2.0);
  scene.run(5);
  scene.crowd.set_preferred_speed(scene.people[person].handle, 0.8);
  scene.step();
  EXPECT_LE(scene.people[person].view.velocity.norm(), 0.8 + 1e-12);
  const double x = scene.people[person].view.position.x();
  scene.run(15);
  EXPECT_NEAR(scene.people[person].view.position.x() - x, 0.8 * 9.9, 0.02 * 8);
}

TEST(Walking, stands_when_its_preferred_speed_is_zero) {
  const Zone zone = zone_of(box(0, 0, 40, 10));
  Scene scene(zone);
  const auto person = scene.add({20, 5}, line_at_x(39, 0, 10), 0.0);
  scene.run(30);
  EXPECT_EQ(scene.arrived(), 0u);
  EXPECT_NEAR((scene.people[person].view.position - Vec2(20, 5)).norm(), 0.0, 0.1);
  EXPECT_EQ(scene.people[person].view.motion, Motion::kStanding);
}

TEST(Walking, is_put_inside_when_given_outside) {
  const Zone zone = zone_of(box(0, 0, 40, 10));
  Scene scene(zone);
  const auto person = scene.add({20, -2}, line_at_x(39, 0, 10));
  EXPECT_NEAR(scene.people[person].path.front().y(), 0.24, 1e-3);
  scene.run(40);
  EXPECT_EQ(scene.arrived(), 1u);
}

TEST(Walking, refuses_numbers_that_are_not_finite) {
  const Zone zone = zone_of(box(0, 0, 40, 10));
  Crowd crowd(zone, 1);
  NewPerson person;
  person.destination = point(1, 1);
  person.position = {std::numeric_limits<double>::quiet_NaN(), 0};
  EXPECT_THROW(crowd.add(person), std::invalid_argument);
  person.position = {5, 5};
  person.destination.b.x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(crowd.add(person), std::invalid_argument);
  EXPECT_EQ(crowd.size(), 0u);
}

TEST(Walking, any_step_length_covers_the_same_time) {
  const Zone zone = zone_of(box(0, 0, 60, 10));
  for (const double step : {0.05, 0.1, 0.25, 0.5, 1.0}) {
    Scene scene(zone);
    const auto person = scene.add({2, 5}, line_at_x(58, 0, 10), 1.34, 0.0);
    scene.run(20, step);
    // tau of start-up are lost whatever the substeps.
    EXPECT_NEAR(scene.people[person].view.position.x(), 2 + 1.34 * (20 - 0.5), 0.02) << step;
  }
}

TEST(Walking, handles_stay_valid_when_others_leave) {
  const Zone zone = zone_of(box(0, 0, 100, 20));
  Crowd crowd(zone, 1);
  std::vector<Crowd::Handle> handles;
  for (int k = 0; k < 10; ++k) {
    NewPerson person;
    person.key = k + 1;
    person.position = {5.0, 1.0 + 1.8 * k};
    person.destination = line_at_x(99, 0, 20);
    handles.push_back(crowd.add(person));
  }
  for (const int k : {0, 9, 4}) crowd.remove(handles[k]);
  crowd.step(0.1, {});
  EXPECT_EQ(crowd.size(), 7u);
  for (const int k : {1, 2, 3, 5, 6, 7, 8}) {
    EXPECT_NEAR(crowd.view(handles[k]).position.y(), 1.0 + 1.8 * k, 0.05);
  }
  EXPECT_EQ(crowd.person_steps(), 7u);
}

}  // namespace
}  // namespace pedzone::test
