// Where a vehicle is within a step: on its way, and where it may be if SUMO has it drive otherwise.
#include "crowd/sense/vehicle_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polyline.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

TEST(VehicleMotion, goes_along_its_way_and_not_along_a_chord_of_it) {
  VehicleState vehicle = vehicle_at({-2.0, 0.0}, 0.0, 2.0, 4.0, 2.0);
  const Polyline corner{{-4.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 30.0}};
  vehicle.way = corner;
  VehicleState later = vehicle;
  for (int k = 0; k < 5; ++k) later = moved_on(later, 0.1);
  EXPECT_TRUE(later.centre.isApprox(Vec2(-1.0, 0.0), 1e-9)) << "straight on to the corner first";
  for (int k = 0; k < 5; ++k) later = moved_on(later, 0.1);
  const Vec2 front = later.centre + unit(later.heading) * 2.0;
  EXPECT_TRUE(front.isApprox(Vec2(1.0, 1.0), 1e-6)) << front.transpose();
}

TEST(VehicleMotion, knows_its_place_on_a_way_that_comes_back_beside_itself) {
  // The way back is 1 m beside the way there: nearest to a front is now one, now the other.
  const Polyline hairpin{{0.0, 0.0}, {10.0, 0.0}, {10.0, 1.0}, {0.0, 1.0}};
  VehicleState vehicle = vehicle_at({2.0, 0.0}, 0.0, 2.0, 4.0, 2.0);
  vehicle.way = hairpin;
  for (int k = 0; k < 40; ++k) vehicle = moved_on(vehicle, 0.1);
  EXPECT_NEAR(vehicle.gone, 8.0, 1e-9);
  const Vec2 front = vehicle.centre + unit(vehicle.heading) * 2.0;
  EXPECT_TRUE(front.isApprox(Vec2(9.0, 1.0), 1e-6)) << front.transpose();
  EXPECT_TRUE(body_shifted(vehicle, -8.0).centre.isApprox(Vec2(2.0, 0.0), 1e-9));
}

/// On a way that turns by 110 degrees the middle of a body that follows its front as a chord goes
/// backwards for a while.
TEST(VehicleMotion, keeps_to_a_way_so_sharp_that_its_middle_goes_backwards) {
  VehicleState vehicle = vehicle_at({0.0, 0.0}, 0.0, 0.0, 6.5, 2.0);
  const Polyline sharp{{-6.5, 0.0}, {0.0, 0.0}, {-3.42, 9.4}};
  vehicle.way = sharp;
  const double speed = 2.0, seconds = 0.5, gone = 0.1;
  const Rectangle now = body_on_way(vehicle, gone);
  const Rectangle then = body_on_way(vehicle, gone + speed * seconds);
  vehicle.gone = gone;
  vehicle.centre = now.centre;
  vehicle.heading = angle_of(now.axis);
  vehicle.velocity = (then.centre - now.centre).normalized() * speed;
  vehicle.yaw_rate = (angle_of(then.axis) - vehicle.heading) / seconds;
  ASSERT_LT(vehicle.velocity.dot(now.axis), 0.0);
  for (int k = 0; k < 5; ++k) vehicle = moved_on(vehicle, 0.1);
  EXPECT_TRUE(vehicle.centre.isApprox(then.centre, 1e-6)) << vehicle.centre.transpose();
}

/// A moped that turns round in less than a step: its middle gets to behind where it was.
TEST(VehicleMotion, turns_round_on_its_way_where_it_is_known_to_drive_forwards) {
  VehicleState vehicle = vehicle_at({-1.0, 0.0}, 0.0, 0.0, 2.0, 0.8);
  const Polyline round{{-2.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}, {-30.0, 2.0}};
  vehicle.way = round;
  vehicle.velocity = {-10.0, 0.0};  // towards where it will be; it drives 10 m
  vehicle.forwards = true;
  for (int k = 0; k < 10; ++k) vehicle = moved_on(vehicle, 0.1);
  EXPECT_TRUE(front_of(vehicle).isApprox(Vec2(-6.0, 2.0), 1e-6)) << front_of(vehicle).transpose();
}

TEST(VehicleMotion, goes_no_farther_than_where_it_leaves_the_network) {
  VehicleState vehicle = vehicle_at({2.0, 0.0}, 0.0, 15.0, 4.0, 2.0);
  const Polyline ends{{0.0, 0.0}, {4.0, 0.0}, {9.0, 0.0}};
  vehicle.way = ends;
  for (const bool leaves : {false, true}) {
    vehicle.leaves = leaves;
    VehicleState later = vehicle;
    for (int k = 0; k < 10; ++k) later = moved_on(later, 0.1);
    EXPECT_NEAR(front_of(later).x(), leaves ? 9.0 : 19.0, 1e-9);
    EXPECT_NEAR(body_shifted(vehicle, 8.0).centre.x(), leaves ? 7.0 : 10.0, 1e-9);
  }
}

TEST(VehicleMotion, that_reverses_leaves_its_way) {
  VehicleState vehicle = vehicle_at({2.0, 0.0}, 0.0, -2.0, 4.0, 2.0);
  const Polyline corner{{0.0, 0.0}, {4.0, 0.0}, {4.0, 30.0}};
  vehicle.way = corner;
  EXPECT_TRUE(moved_on(vehicle, 0.1).centre.isApprox(Vec2(1.8, 0.0), 1e-9));
}

TEST(VehicleMotion, counts_how_far_behind_or_ahead_it_may_be) {
  VehicleState vehicle = vehicle_at({0.0, 0.0}, 0.0, 3.0);
  vehicle.slower = 2.0;
  vehicle.lead = 1.0;
  const VehicleState later = moved_on(moved_on(vehicle, 0.1), 0.1);
  EXPECT_NEAR(later.lag, 0.4, 1e-12);
  EXPECT_NEAR(later.lead, 0.4, 1e-12) << "1 m ahead of where it was";
  EXPECT_EQ(moved_on(later, 1.0).lead, 0.0);
  EXPECT_NEAR(body_shifted(later, -later.lag).centre.x(), 0.2, 1e-12);
}

TEST(VehicleMotion, that_begins_on_a_bend_cuts_the_corner) {
  const Polyline bend{{-4.0, 0.0}, {0.0, 0.0}, {1.0, 1.0}, {1.0, 9.0}};
  VehicleState vehicle = vehicle_at({-2.0, 0.0}, 0.0, 0.0, 4.0, 2.0);
  vehicle.way = bend;
  const Rectangle flanks = flanks_if_started(vehicle, std::sqrt(2.0));
  EXPECT_NEAR(2.0 * flanks.half.x(), 4.0 - std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(angle_of(flanks.axis), std::atan2(1.0, 1.0 + 4.0 - std::sqrt(2.0)), 0.05);
  const Vec2 inside(-1.0, 1.2), outside(-1.0, -1.2), ahead(1.0, 1.0);
  EXPECT_LT(flanks.distance(inside), rectangle_of(vehicle).distance(inside) - 0.05);
  EXPECT_GT(flanks.distance(outside), rectangle_of(vehicle).distance(outside));
  EXPECT_GT(flanks.distance(ahead), 1.0) << "who is ahead may go on";
}

}  // namespace
}  // namespace pedzone::test
