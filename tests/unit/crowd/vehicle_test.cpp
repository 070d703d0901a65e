// People and vehicles.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "crowd/sense/vehicle_motion.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kTouch = 1e-6;
constexpr double kContact = 0.01;  // [m] the limit for a contact with a vehicle

double random_in(double low, double high, std::uint64_t k, std::uint64_t what) {
  return low + (high - low) * random_uniform(79, k, what, Purpose::kPlacement);
}

class OpenSpace : public ::testing::TestWithParam<double> {};

// A vehicle that brakes for nobody drives through people who walk towards it, across and with it.
TEST_P(OpenSpace, people_make_way_for_a_vehicle_that_never_brakes) {
  const double speed = GetParam();
  const Zone zone = zone_of(box(0, 0, 80, 30), {}, true);
  Scene scene(zone);
  for (int k = 0; k < 30; ++k) {
    const Destination to = k % 3 == 0   ? line_at_x(1, 1, 29)
                           : k % 3 == 1 ? line_at_x(79, 1, 29)
                                        : line_at_y(k % 2 == 0 ? 29 : 1, 20, 60);
    NewPerson person;
    person.position = {random_in(20, 70, k, 1), random_in(5, 25, k, 2)};
    person.destination = to;
    person.heading = angle_of(0.5 * (to.a + to.b) - person.position);
    person.place_freely = true;
    scene.add(person);
  }
  scene.vehicles = {vehicle_at({0, 15}, 0.0, speed)};
  scene.run(100 / speed);
  EXPECT_GE(scene.least_vehicle_gap(), -kContact);
  EXPECT_LE(scene.worst_jump(), 0.1);  // by walking, not by being thrown aside
  scene.vehicles.clear();
  scene.run(200);
  EXPECT_EQ(scene.arrived(), scene.people.size());
}

INSTANTIATE_TEST_SUITE_P(Speeds, OpenSpace, ::testing::Values(1.0, 2.0, 3.0));

TEST(Vehicle, head_on_the_way_is_made_early) {
  const Zone zone = zone_of(box(0, 0, 80, 20), {}, true);
  Scene scene(zone);
  const auto person = scene.add({60, 10}, line_at_x(5, 0, 20));
  scene.vehicles = {vehicle_at({10, 10}, 0.0, 2.0)};
  double aside_at =
      -1.0;  // gap ahead of the vehicle when the person has stepped half a metre aside
  while (scene.time < 60 && scene.arrived() == 0) {
    scene.step();
    const Vec2 place = scene.people[person].view.position;
    const double ahead = place.x() - scene.vehicles[0].centre.x() - 2.5;
    if (aside_at < 0.0 && std::abs(place.y() - 10) > 0.5) aside_at = ahead;
  }
  EXPECT_EQ(scene.arrived(), 1u);
  EXPECT_GT(aside_at, 3.0);
  EXPECT_GE(scene.least_vehicle_gap(), 0.1);
}

TEST(Vehicle, from_behind_it_is_heard_and_made_way_for) {
  const Zone zone = zone_of(box(0, 0, 120, 20), {}, true);
  Scene scene(zone);
  scene.add({30, 10}, line_at_x(115, 0, 20));
  scene.vehicles = {vehicle_at({5, 10}, 0.0, 3.0)};
  scene.run(80);
  EXPECT_GE(scene.least_vehicle_gap(), 0.0);
  EXPECT_LE(scene.worst_jump(), 0.05);
  EXPECT_EQ(scene.arrived(), 1u);
}

/// [m/s] the fastest that somebody of 1.3 m/s crosses the ways of vehicles that come soon or later.
double fastest_before_vehicles(double top_speed) {
  Profile adult = *Profiles().find("adult");
  adult.top_speed = top_speed;
  adult.reaction_time = 0.0;
  const Zone zone = zone_of(box(0, 0, 60, 40));
  double fastest = 0.0;
  for (double later = 3.0; later <= 6.0; later += 0.25) {
    Scene scene(zone);
    NewPerson person;
    person.position = {20.0, 20.0};
    person.velocity = {1.3, 0.0};
    person.preferred_speed = 1.3;
    person.destination = line_at_x(40, 5, 35);
    person.profile = &adult;
    person.aware = true;
    const std::size_t i = scene.add(person);
    scene.vehicles = {vehicle_at({25.0, 20.0 - 4.0 * later}, kPi / 2, 4.0)};
    for (int k = 0; k < 60; ++k) {
      scene.step();
      fastest = std::max(fastest, scene.people[i].view.velocity.norm());
    }
  }
  return fastest;
}

TEST(Vehicle, people_hurry_before_one_but_not_beyond_their_top_speed) {
  EXPECT_GT(fastest_before_vehicles(5.0), 1.4);
  EXPECT_LE(fastest_before_vehicles(5.0), 1.2 * 1.3 + 1e-6);
  EXPECT_LE(fastest_before_vehicles(1.35), 1.35 + 1e-6);
  EXPECT_LE(fastest_before_vehicles(1.0), 1.3 + 1e-9);
}

TEST(Vehicle, a_parked_one_is_passed_close) {
  const Zone zone = zone_of(box(0, 0, 40, 12), {}, true);
  Scene scene(zone);
  const auto person = scene.add({3, 6.2}, line_at_x(37, 0, 12));
  scene.vehicles = {vehicle_at({20, 6}, 0.3, 0.0)};
  scene.run(60);
  ASSERT_EQ(scene.arrived(), 1u);
  EXPECT_GE(scene.least_vehicle_gap(), -kContact);
  EXPECT_LT(scene.least_vehicle_gap(), 1.0);
  EXPECT_LT(scene.people[person].arrival_time, 34 / 1.34 * 1.15);
}

TEST(Vehicle, a_lane_too_narrow_for_both_leaves_nobody_under_it) {
  // 2.5 m of street, 1.98 m of vehicle; one niche.
  const Zone zone =
      zone_of(unite(repair(box(0, 0, 60, 2.5)), repair(box(30, 2.4, 32, 4))), {}, true);
  Scene scene(zone);
  for (int k = 0; k < 4; ++k) scene.add({25.0 + 3 * k, 0.6 + 0.4 * k}, line_at_x(2, 0, 2.5));
  scene.vehicles = {vehicle_at({5, 1.25}, 0.0, 1.0, 4.5, 1.98)};
  scene.run(45);
  EXPECT_GE(scene.least_vehicle_gap(), -kContact);
  EXPECT_GE(scene.least_wall_gap(), -kTouch);
}

TEST(Vehicle, people_under_one_that_appears_get_out) {
  const Zone zone = zone_of(box(0, 0, 40, 20));
  Scene scene(zone);
  for (int k = 0; k < 6; ++k) scene.add({17.0 + k, 10.0 + 0.2 * (k % 3)}, line_at_x(38, 0, 20));
  scene.vehicles = {vehicle_at({20, 10}, 0.4, 0.0)};
  for (int k = 0; k < 15; ++k) scene.step();
  for (const auto& p : scene.people) {
    EXPECT_GE(clearance(scene.vehicles[0], p.view.position), p.given.radius - kContact);
  }
  scene.run(60);
  EXPECT_EQ(scene.arrived(), scene.people.size());
}

TEST(Vehicle, a_column_that_outlasts_the_patience_ends_no_walk) {
  const Zone zone = zone_of(box(0, 0, 60, 20));
  Scene scene(zone);
  const auto person = scene.add({30, 4}, line_at_y(19, 25, 35));
  for (int k = 0; k < 12; ++k) scene.vehicles.push_back(vehicle_at({22.0 - 6 * k, 9}, 0.0, 3.0));
  scene.run(90);
  EXPECT_EQ(scene.arrived(), 1u);
  EXPECT_FALSE(scene.people[person].view.gave_up);
  EXPECT_GE(scene.least_vehicle_gap(), -kContact);
  EXPECT_GT(scene.people[person].arrival_time, 20.0);  // it did let the column pass
}

TEST(Vehicle, moves_on_along_its_circle) {
  VehicleState vehicle = vehicle_at({10, 0}, kPi / 2, 2.0);
  vehicle.yaw_rate = 0.2;  // round the origin: radius = speed / yaw rate = 10 m
  for (int k = 0; k < 100; ++k) vehicle = moved_on(vehicle, 0.1);
  // 2 rad on; the chord rule is off by (yaw * dt)^2 / 24 of the way.
  EXPECT_NEAR(vehicle.centre.x(), 10 * std::cos(2.0), 1e-3);
  EXPECT_NEAR(vehicle.centre.y(), 10 * std::sin(2.0), 1e-3);
  EXPECT_NEAR(vehicle.heading, wrap_angle(kPi / 2 + 2.0), 1e-9);
}

TEST(Vehicle, numbers_that_are_not_finite_are_left_out) {
  const Zone zone = zone_of(box(0, 0, 40, 20));
  Scene scene(zone);
  scene.add({5, 10}, line_at_x(38, 0, 20));
  VehicleState broken = vehicle_at({20, 10}, 0, 1);
  broken.centre.x() = std::nan("");
  scene.crowd.step(1.0, std::vector<VehicleState>{broken});
  EXPECT_TRUE(scene.crowd.view(scene.people[0].handle).position.allFinite());
}

}  // namespace
}  // namespace pedzone::test
