// The forces of Helbing and Molnár (1995): values, signs, and that they are the gradients of their
// potentials.
#include "model/social_force.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/vehicle_sweep.hpp"
#include "perceived_scene.hpp"

namespace pedzone::test {
namespace {

using namespace social_force;

/// V(b) of the paper at the place r relative to somebody who walks with `velocity`.
double person_potential(const Vec2& r, const Vec2& velocity) {
  const Vec2 step = velocity * kDeltaT;
  const double sum = r.norm() + (r - step).norm();
  return kV0 * std::exp(-std::sqrt(sum * sum - step.squaredNorm()) / 2.0 / kSigma);
}

TEST(SocialForce, of_a_person_is_the_gradient_of_the_elliptical_potential) {
  constexpr double kSmall = 1e-6;  // [m] for differences; their error is of its square
  const Vec2 velocity(0.9, -0.7);
  for (const Vec2& r : {Vec2(1.0, 0.4), Vec2(-0.6, 0.3), Vec2(2.0, -1.7), Vec2(0.2, -0.9)}) {
    const Vec2 force = person_force(neighbour(-r, velocity), Vec2(1.0, 0.0));
    for (int axis = 0; axis < 2; ++axis) {
      const Vec2 step = kSmall * Vec2::Unit(axis);
      const double slope =
          (person_potential(r + step, velocity) - person_potential(r - step, velocity)) /
          (2.0 * kSmall);
      EXPECT_NEAR(force[axis], -slope, 1e-6) << r.transpose();
    }
  }
}

TEST(SocialForce, of_a_standing_person_is_round_and_pushes_apart) {
  for (const double angle : {0.0, 1.0, 2.5, -2.0}) {
    const Vec2 force = person_force(neighbour(0.8 * unit(angle)), Vec2(1.0, 0.0));
    EXPECT_NEAR(force.norm(), kV0 / kSigma * std::exp(-0.8 / kSigma), 1e-12);
    EXPECT_NEAR(force.dot(unit(angle)), -force.norm(), 1e-12);
  }
}

TEST(SocialForce, of_somebody_who_comes_pushes_aside_sooner_than_of_one_who_goes) {
  const Vec2 ahead(2.0, 0.3), east(1.0, 0.0);
  const Vec2 comes = person_force(neighbour(ahead, Vec2(-1.3, 0.0)), east);
  const Vec2 goes = person_force(neighbour(ahead, Vec2(1.3, 0.0)), east);
  EXPECT_LT(comes.y(), -1.0);
  EXPECT_GT(comes.norm(), 10.0 * goes.norm());
}

TEST(SocialForce, on_the_axis_between_two_steps_points_to_the_right) {
  const Vec2 force = person_force(neighbour(Vec2(1.0, 0.0), Vec2(-1.3, 0.0)), Vec2(1.0, 0.0));
  EXPECT_NEAR(force.x(), 0.0, 1e-12);
  EXPECT_LT(force.y(), 0.0);
}

TEST(SocialForce, of_a_wall_pushes_inwards) {
  const Border wall = border(Vec2(-5.0, 0.5), Vec2(5.0, 0.5), Vec2(0.0, -1.0));
  const Vec2 force = border_force(wall);
  EXPECT_NEAR(force.y(), -kU0 / kR * std::exp(-0.5 / kR), 1e-12);
  EXPECT_EQ(force.x(), 0.0);
  Border touched = border(Vec2(-5.0, 0.0), Vec2(5.0, 0.0), Vec2(0.0, -1.0));
  EXPECT_NEAR(border_force(touched).y(), -kU0 / kR, 1e-12);
}

TEST(SocialForce, of_a_wall_does_not_depend_on_where_it_is_cut) {
  const Vec2 inward(0.0, -1.0);
  Perceived whole = person(), cut = person();
  whole.borders = {border(Vec2(-5.0, 0.5), Vec2(5.0, 0.5), inward)};
  for (const double at : {0.0, 0.1, 3.0}) {
    cut.borders = {border(Vec2(-5.0, 0.5), Vec2(at, 0.5), inward),
                   border(Vec2(at, 0.5), Vec2(5.0, 0.5), inward)};
    cut.borders[1].repeated = cut.borders[1].nearest == cut.borders[0].nearest;
    EXPECT_EQ(total_force(cut), total_force(whole)) << at;
  }
}

TEST(SocialForce, of_a_wall_keeps_nobody_off_a_goal_at_it) {
  Perceived who = person();
  who.goal_distance = 0.76;
  who.borders = {border(Vec2(1.0, -5.0), Vec2(1.0, 5.0), Vec2(-1.0, 0.0))};
  EXPECT_EQ(total_force(who).x(), 0.0);
  who.goal_distance = 0.7;
  EXPECT_LT(total_force(who).x(), 0.0);
}

TEST(SocialForce, of_a_vehicle_drives_out_of_its_way_to_the_nearer_side) {
  // 6 m before a car at 5 m/s, which covers 10 m in its step; half a metre left of its axis.
  const Vec2 force = vehicle_force(vehicle_seen(Vec2(8.5, -0.5), kPi, 5.0), 0.24, 1.0);
  EXPECT_NEAR(force.y(), kV0 / kSigma, 1e-12);
  EXPECT_NEAR(force.x(), 0.0, 1e-12);
}

TEST(SocialForce, of_a_vehicle_that_stands_is_that_of_a_wall) {
  const Vec2 force = vehicle_force(vehicle_seen(Vec2(3.0, 0.0), 0.0, 0.0), 0.24, 1.0);
  EXPECT_NEAR(force.x(), -kU0 / kR * std::exp(-0.5 / kR), 1e-12);
  EXPECT_EQ(force.y(), 0.0);
}

TEST(SocialForce, caution_widens_the_room_left_to_vehicles) {
  const SeenVehicle car = vehicle_seen(Vec2(0.0, 2.0), 0.0, 5.0);
  EXPECT_GT(vehicle_force(car, 0.24, 1.5).norm(), vehicle_force(car, 0.24, 1.0).norm());
}

TEST(SocialForce, counts_half_where_it_comes_from_behind) {
  const Vec2 e(1.0, 0.0);
  EXPECT_EQ(weight(e, Vec2(-1.0, 0.0)), 1.0);
  EXPECT_EQ(weight(e, Vec2(0.0, 1.0)), 1.0);
  EXPECT_EQ(weight(e, -unit(99.0 * kPi / 180.0)), 1.0);
  EXPECT_EQ(weight(e, -unit(101.0 * kPi / 180.0)), kC);
}

TEST(SocialForce, alone_the_speed_relaxes_to_the_preferred_one) {
  Perceived who = person();
  who.velocity = Vec2(0.2, 0.5);
  EXPECT_NEAR((total_force(who) - (Vec2(who.speed, 0.0) - who.velocity) / kTau).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace pedzone::test
