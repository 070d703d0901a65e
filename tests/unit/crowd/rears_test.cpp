// A vehicle that turns swings its rear out: who would step there waits until it has passed.
#include <gtest/gtest.h>

#include <algorithm>

#include "crowd/sense/vehicle_motion.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

class Rears : public ::testing::Test {
 protected:
  /// What becomes of somebody who walks north from (x, y) at 1 m/s, past a vehicle that goes east.
  struct Walk {
    double pushed = 0.0;     ///< [m]
    double waited = 0.0;     ///< [s] slower than half of that
    double northmost = 0.0;  ///< [m] of its places
    double begun = 0.0;      ///< [m] gone in the first half second
  };

  Walk walk(double x, double y, const Polyline& way, double speed = 3.0,
            const std::vector<VehicleState>& others = {}) const {
    Scene scene(zone_, 1, fixed_model({kPi / 2.0, 1.0, 10.0, false}));
    scene.add({x, y}, line_at_y(19.0, x - 9.0, x + 9.0), 1.0);
    VehicleState vehicle = vehicle_at({26.5, 10.0}, 0.0, speed);
    vehicle.way = way;
    vehicle.forwards = true;
    scene.vehicles = {vehicle};
    scene.vehicles.insert(scene.vehicles.end(), others.begin(), others.end());
    Walk walk;
    for (int k = 0; k < 40; ++k) {
      std::vector<VehicleState> later;
      for (const VehicleState& now : scene.vehicles) later.push_back(moved_on(now, 0.1));
      scene.step(0.1);
      scene.vehicles = later;
      for (const VehiclePush& push : scene.crowd.pushes()) walk.pushed += push.way;
      const PersonView now = scene.crowd.view(scene.people[0].handle);
      if (now.velocity.norm() < 0.5) walk.waited += 0.1;
      if (k < 5) walk.begun = now.position.y() - y;
      walk.northmost = std::max(walk.northmost, now.position.y());
    }
    return walk;
  }

  const Zone zone_ = zone_of(box(0, 0, 80, 60));
  const Polyline left_turn_{{24.0, 10.0}, {30.0, 10.0}, {30.0, 50.0}};
};

TEST_F(Rears, that_swing_over_ones_way_are_waited_for) {
  const Walk beside = walk(27.0, 7.5, left_turn_);
  EXPECT_EQ(beside.pushed, 0.0);
  EXPECT_GT(beside.waited, 0.3);
  EXPECT_GT(beside.northmost, 9.5) << "and walks on behind it";
}

TEST_F(Rears, that_swing_elsewhere_hold_nobody_back) {
  EXPECT_EQ(walk(22.0, 7.5, left_turn_).waited, 0.0) << "far behind";
  EXPECT_EQ(walk(27.0, 2.0, left_turn_).waited, 0.0) << "gone by then";
  const Polyline straight{{24.0, 10.0}, {30.0, 10.0}, {70.0, 10.0}};
  EXPECT_EQ(walk(23.5, 8.9, straight).waited, 0.0) << "no bend";
}

TEST_F(Rears, hold_nobody_where_they_swing) {
  // Who goes along the bend's inside gets out of their way only by walking on.
  const Walk inside = walk(27.0, 11.2, left_turn_);
  EXPECT_EQ(inside.waited, 0.0);
}

TEST_F(Rears, hold_nobody_where_another_vehicle_comes) {
  VehicleState other = vehicle_at({9.0, 7.0}, 0.0, 8.0);
  EXPECT_NEAR(walk(27.0, 7.5, left_turn_, 3.0, {other}).begun, 0.5, 0.01) << "it is there in 2 s";
  other.centre.x() = -20.0;
  EXPECT_LT(walk(27.0, 7.5, left_turn_, 3.0, {other}).begun, 0.4) << "it is far away";
}

TEST_F(Rears, hold_nobody_where_the_vehicle_itself_comes_that_turns_round) {
  const Polyline round{{24.0, 10.0}, {30.0, 10.0}, {30.0, 6.8}, {-30.0, 6.8}};
  EXPECT_NEAR(walk(27.5, 7.5, round).begun, 0.5, 0.01);
  const Polyline right_turn{{24.0, 10.0}, {30.0, 10.0}, {30.0, -30.0}};
  EXPECT_LT(walk(27.5, 7.5, right_turn).begun, 0.4) << "it drives away";
}

}  // namespace
}  // namespace pedzone::test
