// Who comes to a crosswalk without priority waits at the kerb for a gap.
#include <gmock/gmock.h>

#include <algorithm>
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

/// Somebody who comes from 2 m before the kerb on the way over the crosswalk, which has no priority
/// unless a test says so.
class Kerbs : public ::testing::Test {
 protected:
  Kerbs() { come(scene_); }

  static void come(Scene& scene) { scene.add({50, 1.0}, point(50, 12.5), 1.3, 0.0); }

  /// A car of 5 m on the near lane (eastward) whose front is so far [m] before x = 50.
  void drive(double away, double speed, double until = 150.0) {
    VehicleState car = vehicle_at({50.0 - away - 2.5, 4.75}, 0.0, speed);
    car.forwards = true;
    ways_.push_back({{car.centre.x() - 2.5, 4.75}, {until, 4.75}});
    scene_.vehicles.push_back(car);
  }

  /// Vehicles know their ways.
  void run(Scene& scene, double time, double dt = 0.1) {
    for (const double end = scene.time + time; scene.time < end - 1e-9;) {
      for (std::size_t v = 0; v < scene.vehicles.size(); ++v) {
        VehicleState& car = scene.vehicles[v];
        ways_[v].front().x() = car.centre.x() - 2.5;
        car.way = ways_[v];
        car.gone = 0.0;
      }
      scene.step(dt);
      most_ = std::max(most_, scene.people[0].path.back().y());
    }
  }
  void run(double time, double dt = 0.1) { run(scene_, time, dt); }

  const PersonView& person() const { return scene_.people[0].view; }

  const Zone zone_ = street(false);
  Scene scene_{zone_};
  std::vector<std::vector<Vec2>> ways_;
  double most_ = 0.0;  ///< [m] farthest across so far
};

constexpr double kKerb = 3.0;  // [m] y

TEST_F(Kerbs, are_walked_over_where_nobody_comes) {
  run(6.0);
  EXPECT_GT(most_, 6.0);
}

TEST_F(Kerbs, are_none_on_another_crosswalk) {
  drive(45.0, 10.0);
  Zone zone = street(false);
  zone.crosswalks = Crosswalks({{{50, 3}, {50, 10}, 4.0, false}, {{46, 1.5}, {54, 1.5}, 3.0}});
  Scene scene{zone};
  come(scene);
  scene.vehicles = scene_.vehicles;
  run(scene, 4.0);
  EXPECT_GT(most_, kKerb) << "it would stand in the way of others there";
}

TEST_F(Kerbs, hold_who_has_no_gap_until_the_vehicle_is_past) {
  drive(45.0, 10.0);
  run(4.0);
  EXPECT_LT(most_, kKerb);
  EXPECT_GT(most_, kKerb - 1.0) << "at the kerb";
  EXPECT_EQ(person().motion, Motion::kWaiting);
  EXPECT_FALSE(person().crosswalk) << "no vehicle gives way to who waits";
  run(6.0);
  EXPECT_GT(most_, 6.0);
}

TEST_F(Kerbs, do_not_hold_who_gets_over_before_the_vehicle_comes) {
  drive(120.0, 10.0);
  run(4.0);
  EXPECT_GT(most_, kKerb + 0.5);
  ASSERT_TRUE(person().crosswalk) << "some vehicles may give way there";
  EXPECT_FALSE(person().crosswalk->priority);
}

TEST_F(Kerbs, do_not_hold_who_has_priority) {
  // Who walks on whatever comes, unless the kerb holds it.
  const Zone zebra = street(true);
  for (const Zone* zone : {&zone_, &zebra}) {
    Scene scene(*zone, 1, blind_model());
    scene.crowd.let_vehicles_through();
    come(scene);
    scene.vehicles = {vehicle_at({2.5, 4.75}, 0.0, 10.0)};
    ways_ = {{{0.0, 4.75}, {150.0, 4.75}}};
    most_ = 0.0;
    run(scene, 1.0);
    EXPECT_EQ(scene.people[0].view.crosswalk.has_value(), zone == &zebra);
    run(scene, 3.0);
    EXPECT_EQ(most_ > kKerb, zone == &zebra);
  }
}

TEST_F(Kerbs, do_not_hold_who_has_priority_over_those_who_come) {
  constexpr int kHere = 7;
  Zone zone = street(false);
  zone.crosswalks = Crosswalks({{{50, 3}, {50, 10}, 4.0, false, kHere}});
  for (const int at : {kHere + 1, kHere}) {
    const std::vector<int> yields_at{at};
    Scene scene(zone, 1, blind_model());
    scene.crowd.let_vehicles_through();
    come(scene);
    scene.vehicles = {vehicle_at({2.5, 4.75}, 0.0, 10.0)};
    scene.vehicles.front().yields_at = yields_at;
    ways_ = {{{0.0, 4.75}, {150.0, 4.75}}};
    most_ = 0.0;
    run(scene, 1.0);
    EXPECT_EQ(scene.people[0].view.crosswalk.has_value(), at == kHere);
    run(scene, 3.0);
    EXPECT_EQ(most_ > kKerb, at == kHere);
  }
}

TEST_F(Kerbs, do_not_hold_who_may_pass_before_a_standing_queue) {
  drive(4.0, 0.0);
  run(6.0);
  EXPECT_GT(most_, 6.0);
}

TEST_F(Kerbs, hold_who_would_stand_before_a_car_that_bars_the_crosswalk) {
  drive(-2.5, 0.0);
  run(20.0);
  EXPECT_LT(most_, kKerb);
}

TEST_F(Kerbs, do_not_hold_who_gets_round_such_a_car) {
  drive(-0.5, 0.0);  // 1.5 m are left
  run(12.0);
  EXPECT_GT(most_, 6.0);
}

TEST_F(Kerbs, do_not_hold_who_has_waited_for_long_where_drivers_can_stop) {
  // No gap: a car every 4 s, 25 m between two.
  for (int k = 0; k < 60; ++k) drive(20.0 + 30.0 * k, 7.0, 3000.0);
  run(60.0);
  EXPECT_LT(most_, kKerb);
  run(12.0);
  EXPECT_GT(most_, kKerb);
}

TEST_F(Kerbs, hold_nobody_by_a_vehicle_that_turns_off_before) {
  drive(45.0, 10.0, 40.0);
  ways_[0].push_back({40.0, -30.0});
  run(3.0);
  EXPECT_GT(most_, kKerb);
}

TEST_F(Kerbs, hold_who_walks_a_whole_step_at_once) {
  drive(45.0, 10.0);
  run(4.0, 1.0);
  EXPECT_LT(most_, kKerb);
}

}  // namespace
}  // namespace pedzone::test
