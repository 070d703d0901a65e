// Vehicles before a zebra crossing that people use.
#include "sumo/plan/right_of_way.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

namespace pedzone {
namespace {

constexpr double kLook = 60.0;

/// A car of 5 m and 1.8 m with its front at the origin, eastward.
FleetVehicle car(double speed) {
  FleetVehicle vehicle;
  vehicle.way = {{-5.0, 0.0}, {0.0, 0.0}, {100.0, 0.0}};
  vehicle.speed = speed;
  vehicle.allowed_speed = 13.9;
  return vehicle;
}

/// Somebody on a crossing of 4 m at x = 30 m, from y = -1.75 to 5.25, who walks north.
PersonAhead northward(double y) {
  return {{30.0, y}, {0.0, 0.0}, 0.24, Crosswalk{{30.0, -1.75}, {30.0, 5.25}, 4.0}};
}

PersonAhead southward(double y) {
  return {{30.0, y}, {0.0, 0.0}, 0.24, Crosswalk{{30.0, 5.25}, {30.0, -1.75}, 4.0}};
}

std::optional<double> way_to(const PersonAhead& person, double speed = 10.0) {
  return way_to_used_crosswalk(car(speed), std::vector{person}, kLook);
}

TEST(RightOfWay, is_before_the_crossing_of_who_waits_at_the_kerb) {
  const auto way = way_to(northward(-2.2));
  ASSERT_TRUE(way);
  EXPECT_NEAR(*way, 28.0, 1e-9);
}

TEST(RightOfWay, is_where_the_vehicle_turns_without_it) {
  constexpr int kHere = 7;
  PersonAhead person = northward(-1.7);
  person.crosswalk->priority = false;
  person.crosswalk->edge = kHere;
  FleetVehicle vehicle = car(10.0);
  vehicle.yields_at = {kHere + 1};
  EXPECT_FALSE(way_to_used_crosswalk(vehicle, std::vector{person}, kLook));
  vehicle.yields_at.push_back(kHere);
  EXPECT_TRUE(way_to_used_crosswalk(vehicle, std::vector{person}, kLook));
  person.position.y() = -2.2;
  EXPECT_FALSE(way_to_used_crosswalk(vehicle, std::vector{person}, kLook)) << "is not on it yet";
  person.position.y() = -1.7;
  vehicle.gave_way = 10.0;
  EXPECT_FALSE(way_to_used_crosswalk(vehicle, std::vector{person}, kLook)) << "it has waited long";
  person.crosswalk->priority = true;
  EXPECT_TRUE(way_to_used_crosswalk(vehicle, std::vector{person}, kLook)) << "a zebra crossing";
}

TEST(RightOfWay, is_not_of_who_uses_none) {
  PersonAhead person = northward(-2.2);
  person.crosswalk.reset();
  EXPECT_FALSE(way_to(person));
}

TEST(RightOfWay, ends_once_the_person_has_come_past) {
  EXPECT_TRUE(way_to(northward(1.0)));
  EXPECT_FALSE(way_to(northward(2.0)));
  EXPECT_TRUE(way_to(southward(-1.0)));
  EXPECT_FALSE(way_to(southward(-1.72)));
}

TEST(RightOfWay, leaves_the_vehicle_through_that_is_over_before) {
  PersonAhead far = southward(5.5);
  far.crosswalk->begin.y() = 25.0;  // a wide street
  far.position.y() = 25.0;
  EXPECT_FALSE(way_to(far, 10.0));
  EXPECT_TRUE(way_to(far, 3.0));
}

TEST(RightOfWay, is_not_on_a_crossing_that_the_way_does_not_meet_or_the_front_has_reached) {
  FleetVehicle turns = car(10.0);
  turns.way = {{-5.0, 0.0}, {0.0, 0.0}, {20.0, 0.0}, {20.0, -50.0}};
  EXPECT_FALSE(way_to_used_crosswalk(turns, std::vector{northward(-2.2)}, kLook));
  FleetVehicle on = car(5.0);
  on.way = {{24.0, 0.0}, {29.0, 0.0}, {100.0, 0.0}};
  EXPECT_FALSE(way_to_used_crosswalk(on, std::vector{northward(-2.2)}, kLook));
  EXPECT_FALSE(way_to_used_crosswalk(car(10.0), std::vector{northward(-2.2)}, 20.0));
}

/// The speed from which it stops within the gap, a second from now on.
SafeSpeeds braking_evenly() {
  const auto stop = [](const FleetVehicle& vehicle, double gap) {
    const double b = vehicle.traits.decel;
    return std::sqrt(b * b + 2.0 * b * gap) - b;
  };
  return {stop,
          [=](const FleetVehicle& vehicle, double gap, double) { return stop(vehicle, gap); }};
}

TEST(RightOfWay, makes_a_vehicle_wait_that_can_in_comfort_and_claims_nothing) {
  FleetVehicle vehicle = car(10.0);
  vehicle.slowed = vehicle.blocked_time = 60.0;
  double way = 0.0;
  for (int step = 0; step < 200; ++step) {
    PersonAhead person = northward(-2.2);
    person.position.x() -= way;
    person.crosswalk->begin.x() -= way;
    person.crosswalk->end.x() -= way;
    const auto order =
        plan_yield(vehicle, std::vector{person}, Parameters(), braking_evenly(), 0.1);
    if (order) {  // from where it looks for people on
      EXPECT_FALSE(order->emergency);
      EXPECT_GE(order->speed, vehicle.speed - 4.5 * 0.1 - 1e-9);
      vehicle.commanded = vehicle.speed = order->speed;
    }
    way += vehicle.speed * 0.1;
  }
  EXPECT_LT(vehicle.speed, 0.5);
  EXPECT_NEAR(way, 28.0, 1.0);
  EXPECT_EQ(vehicle.claim, 0.0);
  EXPECT_EQ(vehicle.blocked_time, 0.0);
}

TEST(RightOfWay, is_not_given_by_one_that_would_have_to_brake_too_hard) {
  FleetVehicle vehicle = car(13.0);
  PersonAhead person = northward(-2.2);
  person.position.x() = person.crosswalk->begin.x() = person.crosswalk->end.x() = 12.0;
  EXPECT_FALSE(plan_yield(vehicle, std::vector{person}, Parameters(), braking_evenly(), 0.1));
}

}  // namespace
}  // namespace pedzone
