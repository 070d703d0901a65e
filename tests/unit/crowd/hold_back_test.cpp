// In steps of 1 s SUMO moves vehicles by metres, and not always as far as was expected: people keep
// out of wherever one may be when the step ends, but nobody is moved out of there.
#include <gtest/gtest.h>

#include <algorithm>

#include "crowd/sense/vehicle_motion.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kRadius = 0.24, kRounding = 1e-6;
constexpr double kHalfWidth = 0.9, kFront = 2.5;  // [m] of a vehicle, from its centre

class HoldBack : public ::testing::Test {
 protected:
  /// Place of somebody who goes north from (x, `from`) at 1.5 m/s for a step of 1 s, past a
  /// vehicle.
  Vec2 place_after(double x, const VehicleState& vehicle, double from) const {
    Scene scene(zone_, 1, fixed_model({kPi / 2.0, 1.5, 10.0, false}));
    scene.add({x, from}, line_at_y(19.0, x - 9.0, x + 9.0), 1.5);
    scene.vehicles = {vehicle};
    scene.step(1.0);
    EXPECT_TRUE(scene.crowd.pushes().empty()) << "nobody is pushed";
    return scene.people[0].view.position;
  }
  /// [m] y of that place. The vehicle's centre is at (30, 10).
  double walked_to(double x, const VehicleState& vehicle, double from = 8.0) const {
    return place_after(x, vehicle, from).y();
  }

  const Zone zone_ = zone_of(box(0, 0, 80, 20));
};

TEST_F(HoldBack, from_where_a_vehicle_still_is_if_it_was_braked) {
  VehicleState vehicle = vehicle_at({30, 10}, 0.0, 6.0);
  const double behind = 29.0;  // passed by its rear after 0.25 s
  EXPECT_NEAR(walked_to(behind, vehicle), 9.5, 0.05) << "as if it were sure to be gone";
  vehicle.slower = 6.0;  // it may stand all the step
  EXPECT_NEAR(walked_to(behind, vehicle), 10.0 - kHalfWidth - kRadius, kRounding);
  vehicle.slower = 1.0;  // it has left there in any case
  EXPECT_NEAR(walked_to(behind, vehicle), 9.5, 0.05);
}

TEST_F(HoldBack, from_all_places_on_a_bend_where_a_vehicle_may_still_be) {
  // It turns left round (30, 10). Half-way its rear hangs over to y = 8.3 beside x = 27.
  const Polyline way{{24.0, 10.0}, {30.0, 10.0}, {30.0, 40.0}};
  VehicleState vehicle = vehicle_at({26.5, 10}, 0.0, 6.0);
  vehicle.way = way;
  vehicle.forwards = true;
  vehicle.yaw_rate = kPi / 2.0;
  EXPECT_NEAR(walked_to(27.0, vehicle, 6.8), 8.3, 0.05) << "as if it were sure to be gone";
  vehicle.slower = 6.0;
  EXPECT_LT(walked_to(27.0, vehicle, 6.8), 8.15);
}

TEST_F(HoldBack, from_where_a_vehicle_may_get_until_the_step_ends) {
  VehicleState vehicle = vehicle_at({30, 10}, 0.0, 1.0);
  const double ahead = 30.0 + kFront + 3.0;
  EXPECT_NEAR(walked_to(ahead, vehicle), 9.5, 0.05) << "as if it were sure to be that slow";
  vehicle.lead = 4.0;
  EXPECT_NEAR(walked_to(ahead, vehicle), 10.0 - kHalfWidth - kRadius, kRounding);
  vehicle.lead = 2.0;
  EXPECT_NEAR(walked_to(ahead, vehicle), 9.5, 0.05);
  vehicle.lead = 14.0;  // longer than its body
  EXPECT_NEAR(walked_to(ahead + 5.0, vehicle), 10.0 - kHalfWidth - kRadius, kRounding);
}

TEST_F(HoldBack, from_where_one_may_get_that_is_expected_to_stand) {
  VehicleState vehicle = vehicle_at({30, 10}, 0.0, 0.0);
  const Polyline way{{27.5, 10.0}, {32.5, 10.0}, {60.0, 10.0}};
  vehicle.way = way;
  vehicle.forwards = true;
  const double ahead = 30.0 + kFront + 1.0;
  EXPECT_NEAR(walked_to(ahead, vehicle), 9.5, 0.05) << "as if it were sure to stand";
  vehicle.lead = 2.0;
  EXPECT_NEAR(walked_to(ahead, vehicle), 10.0 - kHalfWidth - kRadius, kRounding);
}

TEST_F(HoldBack, not_who_is_there_already) {
  VehicleState vehicle = vehicle_at({30, 10}, 0.0, 1.0);
  vehicle.lead = 4.0;
  EXPECT_NEAR(walked_to(30.0 + kFront + 3.0, vehicle, 9.8), 11.3, 0.05) << "and walks on";
}

TEST_F(HoldBack, from_the_flank_of_one_that_may_drive_off_on_a_bend) {
  const Polyline bend{{27.5, 10.0}, {32.5, 10.0}, {34.0, 8.5}, {34.0, -30.0}};
  VehicleState vehicle = vehicle_at({30, 10}, 0.0, 0.0);
  vehicle.way = bend;
  const double beside = 30.0;
  const double standing = walked_to(beside, vehicle);
  EXPECT_GT(standing, 10.0 - kHalfWidth - kRadius - 0.06) << "close to one that stands";
  vehicle.starts = 2.0;
  EXPECT_LT(walked_to(beside, vehicle), standing - 0.05) << "it would cut the corner";
}

TEST_F(HoldBack, from_all_places_to_which_one_may_drive_off) {
  // In the end it has turned away from who comes from the right.
  const Polyline way{{24.0, 10.0}, {30.5, 10.0}, {30.5, 40.0}};
  VehicleState vehicle = vehicle_at({26.5, 10}, 0.0, 0.0);
  vehicle.way = way;
  EXPECT_NEAR(walked_to(30.3, vehicle), 9.5, 0.05) << "it stands";
  vehicle.starts = 3.5;
  EXPECT_LT(walked_to(30.3, vehicle), 9.2);
}

TEST_F(HoldBack, from_every_place_on_a_turn_about_to_which_one_may_drive_off) {
  const Polyline way{{24.0, 10.0}, {29.0, 10.0}, {30.0, 11.5}, {29.0, 13.0}, {0.0, 13.0}};
  VehicleState vehicle = vehicle_at({26.5, 10}, 0.0, 0.0);
  vehicle.way = way;
  vehicle.starts = 4.0;
  const auto nearest = [&](const Vec2& place) {
    double least = 100.0;
    for (double ahead = 0.0; ahead <= vehicle.starts; ahead += 0.02)
      least = std::min(least, body_if_started(vehicle, ahead).distance(place));
    return least;
  };
  for (double x = 22.0; x <= 31.0; x += 0.1) {
    for (double from = 7.4; from <= 8.8; from += 0.2) {
      const double room = nearest(place_after(x, vehicle, from));
      EXPECT_GT(room, std::min(kRadius, nearest({x, from})) - 0.03) << x << " " << from;
    }
  }
}

TEST_F(HoldBack, from_before_one_that_may_drive_off) {
  VehicleState vehicle = vehicle_at({30, 10}, 0.0, 0.0);
  const Polyline way{{27.5, 10.0}, {32.5, 10.0}, {60.0, 10.0}};
  vehicle.way = way;
  const double ahead = 30.0 + kFront + 2.0;
  EXPECT_NEAR(walked_to(ahead, vehicle), 9.5, 0.05) << "it stands";
  vehicle.starts = 2.6;
  EXPECT_NEAR(walked_to(ahead, vehicle), 10.0 - kHalfWidth - kRadius, kRounding);
  EXPECT_NEAR(walked_to(ahead, vehicle, 9.8), 11.3, 0.05) << "who is there already walks on";
  vehicle.starts = 1.0;
  EXPECT_NEAR(walked_to(ahead, vehicle), 9.5, 0.05) << "it does not get so far";
}

}  // namespace
}  // namespace pedzone::test
