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
  };

  Walk walk(double x, double y, const Polyline& way, double speed = 3.0) const {
    Scene scene(zone_, 1, fixed_model({kPi / 2.0, 1.0, 10.0, false}));
    scene.add({x, y}, line_at_y(19.0, x - 9.0, x + 9.0), 1.0);
    VehicleState vehicle = vehicle_at({26.5, 10.0}, 0.0, speed);
    vehicle.way = way;
    vehicle.forwards = true;
    scene.vehicles = {vehicle};
    Walk walk;
    for (int k = 0; k < 40; ++k) {
      const VehicleState later = moved_on(scene.vehicles[0], 0.1);
      scene.step(0.1);
      scene.vehicles[0] = later;
      for (const VehiclePush& push : scene.crowd.pushes()) walk.pushed += push.way;
      const PersonView now = scene.crowd.view(scene.people[0].handle);
      if (now.velocity.norm() < 0.5) walk.waited += 0.1;
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

}  // namespace
}  // namespace pedzone::test
