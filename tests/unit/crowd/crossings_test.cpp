// Crossing a street between the junctions: where, when, together, and what a car on its way does
// to it.
#include "crowd/behaviour/crossings.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>

#include "group_scene.hpp"
#include "street_scene.hpp"

namespace pedzone::test {
namespace {

class Crossing : public ::testing::Test {
 protected:
  /// Somebody who stands at a door and wants to the one across.
  NewPerson across(double x, double to_x, std::string_view kind = "adult") const {
    NewPerson person = member({x, -4.6}, point(to_x, 4.6), 0);
    person.velocity = Vec2::Zero();
    person.profile = profile(kind);
    person.aware = true;
    return person;
  }

  /// Runs until somebody steps out or `until` [s].
  std::vector<CrossingBegun> step_until_out(Scene& scene, double until) const {
    while (scene.time < until) {
      scene.step();
      const auto begun = scene.crowd.crossings();
      if (!begun.empty()) return {begun.begin(), begun.end()};
    }
    return {};
  }

  /// People at many doors, and cars that come on both lanes `apart` [m] from each other.
  void fill(Scene& scene, double apart) const {
    for (double x = 20.0; x <= 180.0; x += 20.0) scene.add(across(x, x));
    for (double away = 30.0; away < 400.0; away += apart) {
      scene.vehicles.push_back(car_before(100.0, away, 12.0));
      scene.vehicles.push_back(car_before(100.0, away + 13.0, 12.0, false));
    }
    scene.crowd.let_vehicles_through();
  }

  const Zone zone_ = street_zone();
};

TEST_F(Crossing, leads_straight_across_an_empty_street) {
  Scene scene(zone_);
  const std::size_t i = scene.add(across(100.0, 100.0));
  scene.run(30.0);
  ASSERT_GE(scene.people[i].arrival_time, 0.0);
  EXPECT_LT(scene.people[i].walked, 10.0);
  EXPECT_LT(scene.people[i].arrival_time, 12.0);
}

TEST_F(Crossing, is_along_the_way_where_the_doors_are_not_opposite) {
  Scene scene(zone_);
  const std::size_t i = scene.add(across(60.0, 100.0));
  scene.run(60.0);
  ASSERT_GE(scene.people[i].arrival_time, 0.0);
  EXPECT_LT(scene.people[i].walked, 40.0 + 9.2 + 2.0);
}

TEST_F(Crossing, waits_at_the_kerb_for_a_car_and_then_goes) {
  Scene scene(zone_);
  const std::size_t i = scene.add(across(100.0, 100.0));
  scene.vehicles = {car_before(100.0, 40.0, 10.0)};
  for (int k = 0; k < 38; ++k) scene.step();
  EXPECT_LT(scene.people[i].view.position.y(), -3.5);
  EXPECT_EQ(scene.people[i].view.motion, Motion::kWaiting);
  const auto begun = step_until_out(scene, 20.0);
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_GT(begun.front().time, 4.0);
  EXPECT_LT(begun.front().time, 6.5);
  ASSERT_EQ(begun.front().rejected.size(), 1U);
  EXPECT_NEAR(begun.front().rejected.front(), 4.0, 0.6);
  EXPECT_GT(begun.front().waited, 0.5);
}

TEST_F(Crossing, does_not_wait_for_a_car_of_the_far_lane_that_is_past_before) {
  Scene scene(zone_);
  scene.add(across(100.0, 100.0));
  scene.vehicles = {car_before(100.0, 20.0, 12.0, false)};
  const auto begun = step_until_out(scene, 10.0);
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_LT(begun.front().time, 2.5);
}

TEST_F(Crossing, keeps_a_body_clear_of_cars_that_come_on_both_lanes) {
  Scene scene(zone_);
  fill(scene, 55.0);
  scene.run(120.0);
  EXPECT_EQ(scene.arrived(), scene.people.size());
  EXPECT_GT(scene.least_vehicle_gap(), 0.1);
}

TEST_F(Crossing, of_a_model_that_minds_nothing_meets_cars) {
  Zone blind = zone_;
  blind.model = "constant-velocity";
  Scene scene(blind);
  fill(scene, 25.0);
  scene.run(60.0);
  EXPECT_LT(scene.least_vehicle_gap(), -0.05);
}

TEST_F(Crossing, of_who_is_unaware_is_without_looking) {
  Scene scene(zone_);
  NewPerson person = across(100.0, 100.0);
  person.aware = false;
  scene.add(person);
  scene.vehicles = {car_before(100.0, 25.0, 10.0)};
  const auto begun = step_until_out(scene, 10.0);
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_FALSE(begun.front().looked);
  EXPECT_LT(begun.front().time, 1.5);
}

TEST_F(Crossing, is_left_for_the_junction_by_who_has_waited_as_long_as_that_takes) {
  Scene scene(zone_);
  const std::size_t i = scene.add(across(20.0, 20.0));
  for (double away = 5.0; away < 2000.0; away += 30.0) {
    scene.vehicles.push_back(car_before(20.0, away, 10.0));
  }
  scene.run(180.0);
  ASSERT_GE(scene.people[i].arrival_time, 0.0);
  EXPECT_GT(scene.people[i].walked, 40.0);
}

TEST_F(Crossing, is_no_childs_own_business) {
  Scene scene(zone_);
  const std::size_t child = scene.add(across(20.0, 20.0, "child"));
  scene.run(120.0);
  ASSERT_GE(scene.people[child].arrival_time, 0.0);
  EXPECT_GT(scene.people[child].walked, 40.0);
}

TEST_F(Crossing, is_left_to_sumo_where_nobody_gets_across) {
  Zone zone =
      zone_of(unite(repair(box(0.0, -5.5, 200.0, -3.5)), repair(box(0.0, 3.5, 200.0, 5.5))));
  zone.streets = zone_.streets;
  zone.street_walls = zone_.street_walls;
  NewPerson person = across(100.0, 100.0);
  for (const bool open : {true, false}) {
    for (CrossingPlace& place : zone.streets.front().places) place.open = open;
    for (const double by_junctions : {12.0, 60.0}) {  // hardly longer than straight across, much
      person.by_junctions = by_junctions;
      Scene scene(zone);
      const std::size_t i = scene.add(person);
      EXPECT_EQ(scene.people[i].view.stays_outside, !open || by_junctions < 20.0);
    }
  }
}

TEST_F(Crossing, is_together_for_a_group_or_not_at_all) {
  Scene scene(zone_);
  for (const double x : {99.0, 100.0, 101.0}) {
    NewPerson person = across(x, x);
    person.group = 7;
    person.preferred_speed = x == 100.0 ? 0.8 : 1.5;
    scene.add(person);
  }
  scene.vehicles = {car_before(100.0, 75.0, 10.0)};  // enough for the two, not for the slow one
  const auto begun = step_until_out(scene, 30.0);
  EXPECT_EQ(begun.size(), 3U);
  EXPECT_GT(begun.front().time, 7.0);
}

TEST_F(Crossing, takes_a_child_along_by_its_adult) {
  Scene scene(zone_);
  NewPerson adult = across(100.0, 100.0), child = across(100.6, 100.0, "child");
  adult.group = child.group = 7;
  scene.add(adult);
  const std::size_t small = scene.add(child);
  scene.run(60.0);
  ASSERT_GE(scene.people[small].arrival_time, 0.0);
  EXPECT_LT(scene.people[small].walked, 15.0);
}

TEST_F(Crossing, avoids_a_parked_car_at_the_kerb) {
  Scene scene(zone_);
  const std::size_t i = scene.add(across(100.0, 100.0));
  scene.vehicles = {vehicle_at({100.0, -2.5}, 0.0, 0.0)};
  scene.run(60.0);
  ASSERT_GE(scene.people[i].arrival_time, 0.0);
  EXPECT_LT(scene.people[i].walked, 25.0);
  EXPECT_GE(scene.least_vehicle_gap(), 0.0);
}

TEST_F(Crossing, is_slow_until_parked_cars_hide_no_lane_any_more) {
  std::array<double, 2> slowest{9.0, 9.0};
  for (const bool parked : {false, true}) {
    Scene scene(zone_);
    const std::size_t i = scene.add(across(20.0, 20.0));
    for (const double x : {16.8, 23.2}) {
      if (parked) scene.vehicles.push_back(vehicle_at({x, -2.5}, 0.0, 0.0));
    }
    while (scene.time < 60.0 && scene.people[i].here) {
      scene.step();
      const double y = scene.people[i].view.position.y();
      const double speed = scene.people[i].view.velocity.norm();
      if (y > -3.3 && y < 3.3) slowest[parked] = std::min(slowest[parked], speed);
    }
    EXPECT_FALSE(scene.people[i].here);
    EXPECT_NEAR(scene.people[i].walked, 10.0, 1.5);
  }
  EXPECT_GT(slowest[false], 1.0);
  EXPECT_LT(slowest[true], 0.6);
  EXPECT_GT(slowest[true], 0.25);
}

TEST_F(Crossing, is_given_up_at_the_edge_of_a_lane_where_no_gap_comes) {
  Scene scene(zone_);
  const std::size_t i = scene.add(across(20.0, 20.0));
  // Parked cars hide those that come.
  for (const double x : {-22.0, -16.0, -10.0, 3.0, 8.0, 14.0}) {
    scene.vehicles.push_back(vehicle_at({x, -2.5}, 0.0, 0.0));
  }
  for (double away = 5.0; away < 2000.0; away += 16.0) {
    VehicleState car = car_before(20.0, away, 10.0);
    car.centre.y() = 0.0;
    scene.vehicles.push_back(car);
  }
  bool stepped_out = false;
  while (scene.time < 400.0 && scene.people[i].here) {
    scene.step();
    stepped_out = stepped_out || scene.people[i].view.crosses;
  }
  EXPECT_TRUE(stepped_out);
  EXPECT_GT(scene.people[i].walked, 40.0);
  EXPECT_GE(scene.people[i].arrival_time, 0.0);
}

TEST_F(Crossing, goes_round_a_car_that_has_come_to_stand_on_the_other_side) {
  Scene scene(zone_);
  const std::size_t i = scene.add(across(100.0, 100.0));
  while (scene.people[i].view.position.y() < -1.5) scene.step();
  scene.vehicles = {vehicle_at({102.6, 2.5}, 0.0, 0.0)};  // its rear is at 100.1 m
  scene.run(40.0);
  ASSERT_GE(scene.people[i].arrival_time, 0.0);
  EXPECT_LT(scene.people[i].walked, 20.0);
  EXPECT_GE(scene.least_vehicle_gap(), 0.0);
}

TEST_F(Crossing, goes_along_a_car_that_has_come_to_stand_right_before_it) {
  Scene scene(zone_);
  const std::size_t i = scene.add(across(100.0, 100.0));
  while (scene.people[i].view.position.y() < 1.0) scene.step();
  scene.vehicles = {vehicle_at({101.5, 2.5}, 0.0, 0.0)};  // 0.4 m before its body
  const double since = scene.time;
  while (scene.people[i].view.position.y() < 4.0 && scene.time < since + 20.0) scene.step();
  EXPECT_LT(scene.time, since + 6.0);
  EXPECT_GE(scene.least_vehicle_gap(), 0.0);
}

TEST_F(Crossing, is_over_once_the_other_side_is_reached) {
  Scene scene(zone_);
  const std::size_t i = scene.add(across(100.0, 150.0));
  bool crossed = false;
  while (scene.time < 90.0 && scene.people[i].here) {
    scene.step();
    const PersonView& view = scene.people[i].view;
    crossed = crossed || view.crosses;
    // Until the body is on the ground behind the kerb.
    EXPECT_EQ(view.crosses && view.position.y() > 3.5 + 0.3, false);
  }
  EXPECT_TRUE(crossed);
}

}  // namespace
}  // namespace pedzone::test
