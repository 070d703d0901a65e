// The functions of Dietrich and Köster (2014): values and signs.
#include "model/gradient_navigation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "perceived_scene.hpp"

namespace pedzone::test {
namespace {

using namespace gradient_navigation;

constexpr double kDegree = kPi / 180.0;

TEST(GradientNavigation, h_falls_smoothly_from_p_over_e_to_nothing_at_its_range) {
  EXPECT_NEAR(h(0.0, 3.0, 0.7), 3.0 / std::exp(1.0), 1e-12);
  EXPECT_NEAR(h(0.35, 3.0, 0.7), 3.0 * std::exp(-4.0 / 3.0), 1e-12);
  EXPECT_EQ(h(0.7, 3.0, 0.7), 0.0);
  EXPECT_LT(h(0.69, 3.0, 0.7), 1e-10);
}

TEST(GradientNavigation, g_cuts_lengths_at_one) {
  EXPECT_EQ(g(Vec2(0.3, -0.4)), Vec2(0.3, -0.4));
  EXPECT_NEAR((g(Vec2(3.0, -4.0)) - Vec2(0.6, -0.8)).norm(), 0.0, 1e-12);
  EXPECT_EQ(g(Vec2::Zero()), Vec2::Zero());
}

TEST(GradientNavigation, sees_ahead_not_behind_and_half_at_100_degrees) {
  EXPECT_NEAR(sight(0.0), 1.0, 1e-4);
  EXPECT_NEAR(sight(100.0 * kDegree), 0.5, 1e-12);
  EXPECT_LT(sight(150.0 * kDegree), 1e-3);
}

TEST(GradientNavigation, persons_push_apart_and_wider_ones_from_farther) {
  const Vec2 east(1.0, 0.0);
  const Vec2 push = person_gradient(neighbour(Vec2(0.5, 0.2)), east, 0.24);
  EXPECT_LT(push.x(), 0.0);
  EXPECT_LT(push.y(), 0.0);
  EXPECT_NEAR(cross(push, Vec2(0.5, 0.2)), 0.0, 1e-12);
  EXPECT_GT(person_gradient(neighbour(Vec2(0.5, 0.2), Vec2::Zero(), 0.4), east, 0.24).norm(),
            push.norm());
  EXPECT_EQ(person_gradient(neighbour(Vec2(0.8, 0.0)), east, 0.24), Vec2::Zero());
}

TEST(GradientNavigation, walls_push_inwards) {
  Perceived who = person();
  who.borders = {border(Vec2(-5.0, 0.26), Vec2(5.0, 0.26), Vec2(0.0, -1.0))};
  const Vec2 n = navigation(who);
  EXPECT_LT(n.y(), -0.1);
  EXPECT_GT(n.x(), 0.0);
}

TEST(GradientNavigation, stops_before_a_wall_across_its_way) {
  // Where h = 1, the wall outweighs the goal.
  Perceived who = person();
  who.borders = {border(Vec2(0.2, -5.0), Vec2(0.2, 5.0), Vec2(-1.0, 0.0))};
  EXPECT_LT(navigation(who).norm(), 0.01);
}

TEST(GradientNavigation, steps_out_of_a_vehicles_way_to_the_nearer_side) {
  Perceived who = person();
  who.vehicles = {vehicle_seen(Vec2(8.5, -0.5), kPi, 5.0)};
  EXPECT_GT(navigation(who).y(), 0.5);
  who.vehicles = {vehicle_seen(Vec2(8.5, 0.5), kPi, 5.0)};
  EXPECT_LT(navigation(who).y(), -0.5);
}

TEST(GradientNavigation, stops_before_the_room_that_a_crossing_vehicle_takes) {
  Perceived who = person();
  who.vehicles = {vehicle_seen(Vec2(0.2 + 0.9, -6.0), kPi / 2.0, 5.0)};
  EXPECT_LT(navigation(who).norm(), 0.05);
}

}  // namespace
}  // namespace pedzone::test
