// The optimal steps model of Seitz and Köster (2012): lengths, potentials, and where people step.
#include "model/optimal_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "perceived_scene.hpp"

namespace pedzone::test {
namespace {

using namespace optimal_steps;

TEST(OptimalSteps, are_longer_the_faster_people_walk) {
  EXPECT_NEAR(step_length(1.34), 0.462 + 0.235 * 1.34, 1e-12);
}

TEST(OptimalSteps, potentials_fall_with_the_gap_and_end) {
  for (const auto potential_of : {person_potential, obstacle_potential}) {
    EXPECT_GT(potential_of(-0.01), 1000.0 - 1e-9);
    double before = potential_of(0.001);
    for (double gap = 0.05; gap < 1.0; gap += 0.05) {
      EXPECT_LT(potential_of(gap), before) << gap;
      before = potential_of(gap);
    }
  }
  EXPECT_EQ(person_potential(1.001), 0.0);
  EXPECT_EQ(obstacle_potential(6.001), 0.0);
}

TEST(OptimalSteps, alone_lead_straight_to_the_goal) {
  EXPECT_EQ(best_step(person(), 0.7), Vec2(0.7, 0.0));
}

TEST(OptimalSteps, lead_round_somebody_who_stands_and_keep_clear_of_them) {
  Perceived who = person();
  for (const double side : {-1.0, 1.0}) {
    who.neighbours = {neighbour(Vec2(0.8, side * 0.1))};
    const Vec2 step = best_step(who, 0.7);
    EXPECT_LT(side * step.y(), -0.1);
    EXPECT_GT((step - who.neighbours[0].offset).norm(), 0.48);
  }
}

TEST(OptimalSteps, never_lead_through_a_wall_however_thin) {
  // Far behind the wall the potential of its nearest point is nothing.
  Perceived who = person();
  who.borders = {border(Vec2(0.3, -20.0), Vec2(0.3, 20.0), Vec2(-1.0, 0.0))};
  for (const double length : {0.7, 5.0}) EXPECT_LT(best_step(who, length).x(), 0.06 + 1e-9);
}

TEST(OptimalSteps, of_somebody_shut_in_is_to_stay) {
  Perceived who = person();
  for (int k = 0; k < 8; ++k) who.neighbours.push_back(neighbour(0.6 * unit(k * kPi / 4.0)));
  EXPECT_EQ(best_step(who, 0.7), Vec2::Zero());
}

TEST(OptimalSteps, lead_out_of_a_vehicles_way_to_the_nearer_side) {
  Perceived who = person();
  for (const double side : {-1.0, 1.0}) {
    who.vehicles = {vehicle_seen(Vec2(8.5, -0.5 * side), kPi, 5.0)};
    EXPECT_GT(side * best_step(who, 0.7).y(), 0.6);
  }
}

TEST(OptimalSteps, stop_before_the_room_that_a_crossing_vehicle_takes) {
  Perceived who = person();
  who.vehicles = {vehicle_seen(Vec2(0.24 + 0.1 + 0.9, -6.0), kPi / 2.0, 5.0)};
  EXPECT_LT(best_step(who, 0.7).x(), 0.1);
}

TEST(OptimalSteps, end_once_in_each_duration_whatever_the_simulations_step) {
  constexpr double kDuration = 0.58;
  for (const double dt : {0.01, 0.1, 0.25}) {
    for (const double phase : {0.0, 0.3, 0.9}) {
      int ends = 0;
      for (int k = 1; k * dt <= 58.0 + 1e-9; ++k) ends += step_ends(k * dt, dt, kDuration, phase);
      EXPECT_NEAR(ends, 100, 1) << dt << " " << phase;
    }
  }
}

}  // namespace
}  // namespace pedzone::test
