// Who comes to a crosswalk without priority waits at the kerb for a gap.
#include <gmock/gmock.h>

#include <vector>

#include "scene.hpp"

namespace pedzone::test {
namespace {

/// Footways of 3 m beside a carriageway of two lanes of 3.5 m, from y = 3 to y = 10, and a
/// crosswalk of 4 m over it at x = 50.
Zone street(bool priority) {
  Zone zone = zone_of(Ring{{0, 0},
                           {100, 0},
                           {100, 3},
                           {52, 3},
                           {52, 10},
                           {100, 10},
                           {100, 13},
                           {0, 13},
                           {0, 10},
                           {48, 10},
                           {48, 3},
                           {0, 3}});
  zone.crosswalks = Crosswalks({{{50, 3}, {50, 10}, 4.0, priority}});
  return zone;
}

class Kerbs : public ::testing::Test {
 protected:
  /// Somebody 5 m before the crosswalk, on the way over it.
  static void come(Scene& scene) { scene.add({50, 1.0}, point(50, 12.5), 1.3, 0.0); }

  /// A car of 5 m on the near lane (eastward) whose front is so far [m] before x = 50.
  void drive(Scene& scene, double away, double speed, double until = 150.0) {
    VehicleState car = vehicle_at({50.0 - away - 2.5, 4.75}, 0.0, speed);
    car.forwards = true;
    ways_.push_back({{car.centre.x() - 2.5, 4.75}, {until, 4.75}});
    scene.vehicles.push_back(car);
  }

  /// Steps that long; vehicles know their ways.
  void run(Scene& scene, double time) {
    for (const double end = scene.time + time; scene.time < end - 1e-9;) {
      for (std::size_t v = 0; v < scene.vehicles.size(); ++v) {
        VehicleState& car = scene.vehicles[v];
        ways_[v].front().x() = car.centre.x() - 2.5;
        car.way = ways_[v];
        car.gone = 0.0;
      }
      scene.step();
      most_ = std::max(most_, scene.people[0].path.back().y());
    }
  }

  std::vector<std::vector<Vec2>> ways_;
  double most_ = 0.0;  ///< [m] farthest across so far
};

constexpr double kKerb = 3.0;  // [m] y

TEST_F(Kerbs, are_walked_over_where_nobody_comes) {
  const Zone zone = street(false);
  Scene scene(zone);
  come(scene);
  run(scene, 6.0);
  EXPECT_GT(most_, 6.0);
}

TEST_F(Kerbs, hold_who_has_no_gap_until_the_vehicle_is_past) {
  const Zone zone = street(false);
  Scene scene(zone);
  come(scene);
  drive(scene, 45.0, 10.0);
  run(scene, 4.0);
  EXPECT_LT(most_, kKerb);
  EXPECT_GT(most_, kKerb - 1.0) << "at the kerb";
  EXPECT_EQ(scene.people[0].view.motion, Motion::kWaiting);
  EXPECT_FALSE(scene.people[0].view.zebra) << "no vehicle gives way to who waits";
  run(scene, 6.0);
  EXPECT_GT(most_, 6.0);
}

TEST_F(Kerbs, do_not_hold_who_gets_over_before_the_vehicle_comes) {
  const Zone zone = street(false);
  Scene scene(zone);
  come(scene);
  drive(scene, 120.0, 10.0);
  run(scene, 4.0);
  EXPECT_GT(most_, kKerb + 0.5);
  EXPECT_FALSE(scene.people[0].view.zebra) << "has no priority";
}

TEST_F(Kerbs, do_not_hold_who_has_priority) {
  const Zone zone = street(true);
  Scene scene(zone);
  scene.crowd.let_vehicles_through();
  come(scene);
  drive(scene, 60.0, 4.0);
  run(scene, 1.0);
  EXPECT_TRUE(scene.people[0].view.zebra);
}

TEST_F(Kerbs, do_not_hold_who_may_pass_before_a_standing_queue) {
  const Zone zone = street(false);
  Scene scene(zone);
  come(scene);
  drive(scene, 4.0, 0.0);
  run(scene, 6.0);
  EXPECT_GT(most_, 6.0);
}

TEST_F(Kerbs, hold_who_would_stand_before_a_car_that_bars_the_crosswalk) {
  const Zone zone = street(false);
  Scene scene(zone);
  come(scene);
  drive(scene, -2.5, 0.0);
  run(scene, 20.0);
  EXPECT_LT(most_, kKerb);
}

TEST_F(Kerbs, do_not_hold_who_gets_round_such_a_car) {
  const Zone zone = street(false);
  Scene scene(zone);
  come(scene);
  drive(scene, -0.5, 0.0);  // 1.5 m are left
  run(scene, 12.0);
  EXPECT_GT(most_, 6.0);
}

TEST_F(Kerbs, do_not_hold_who_has_waited_for_long_where_drivers_can_stop) {
  const Zone zone = street(false);
  Scene scene(zone);
  come(scene);
  // No gap: a car every 4 s, 25 m between two.
  for (int k = 0; k < 60; ++k) drive(scene, 20.0 + 30.0 * k, 7.0, 3000.0);
  run(scene, 60.0);
  EXPECT_LT(most_, kKerb);
  run(scene, 12.0);
  EXPECT_GT(most_, kKerb);
}

TEST_F(Kerbs, hold_nobody_by_a_vehicle_that_turns_off_before) {
  const Zone zone = street(false);
  Scene scene(zone);
  come(scene);
  drive(scene, 45.0, 10.0, 40.0);
  ways_[0].push_back({40.0, -30.0});
  run(scene, 3.0);
  EXPECT_GT(most_, kKerb);
}

TEST_F(Kerbs, hold_who_walks_a_whole_step_at_once) {
  const Zone zone = street(false);
  Scene scene(zone);
  come(scene);
  drive(scene, 45.0, 10.0);
  for (int k = 0; k < 4; ++k) {
    scene.vehicles[0].way = ways_[0];
    ways_[0].front().x() = scene.vehicles[0].centre.x() - 2.5;
    scene.step(1.0);
    EXPECT_LT(scene.people[0].path.back().y(), kKerb);
  }
}

}  // namespace
}  // namespace pedzone::test
