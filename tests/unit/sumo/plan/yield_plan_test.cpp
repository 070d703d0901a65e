// Who is in a vehicle's way, and how fast it is told to drive.
#include "sumo/plan/yield_plan.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <tuple>
#include <vector>

namespace pedzone {
namespace {

constexpr double kMargin = 0.2, kLook = 20.0;

/// A shuttle 4 m long and 2 m wide with its front at the origin, on its way along `ahead`.
FleetVehicle shuttle(const Polyline& ahead) {
  FleetVehicle vehicle;
  vehicle.traits.length = 4.0;
  vehicle.traits.width = 2.0;
  vehicle.way = {{-4.0, 0.0}, {0.0, 0.0}};
  vehicle.way.insert(vehicle.way.end(), ahead.begin(), ahead.end());
  return vehicle;
}

std::optional<Obstruction> ahead_of(const FleetVehicle& vehicle, const PersonAhead& person) {
  return first_in_way(vehicle, std::vector{person}, kMargin, kLook);
}

const FleetVehicle kStraight = shuttle({{30.0, 0.0}});

TEST(FirstInWay, is_the_person_before_the_bumper) {
  const auto found = ahead_of(kStraight, {{10.0, 0.0}, {0.0, 0.0}, 0.24});
  ASSERT_TRUE(found);
  // Contact when the front is at 10 - 0.24 - margin; the sampling may stop up to 0.5 m before.
  EXPECT_LE(found->distance, 10.0 - 0.24 - kMargin + 1e-9);
  EXPECT_GE(found->distance, 10.0 - 0.24 - kMargin - 0.6);
}

TEST(FirstInWay, is_the_nearest_of_several) {
  const std::vector<PersonAhead> people{{{15.0, 0.0}, {0, 0}, 0.24}, {{6.0, 0.5}, {0, 0}, 0.24}};
  const auto found = first_in_way(kStraight, people, kMargin, kLook);
  ASSERT_TRUE(found);
  EXPECT_LT(found->distance, 6.0);
}

TEST(FirstInWay, passes_a_person_that_stands_beside_the_way) {
  EXPECT_FALSE(ahead_of(kStraight, {{10.0, 1.5}, {0.0, 0.0}, 0.24}));
}

TEST(FirstInWay, sees_a_person_about_to_step_in) {
  EXPECT_TRUE(ahead_of(kStraight, {{10.0, 2.0}, {0.0, -1.3}, 0.24}));
}

TEST(FirstInWay, ignores_a_person_that_walks_away_beside_it) {
  EXPECT_FALSE(ahead_of(kStraight, {{10.0, 2.0}, {0.0, 1.3}, 0.24}));
}

TEST(FirstInWay, ignores_who_is_behind) {
  EXPECT_FALSE(ahead_of(kStraight, {{-6.0, 0.0}, {0.0, 0.0}, 0.24}));
}

TEST(FirstInWay, ignores_who_stands_close_beside_the_body) {
  EXPECT_FALSE(ahead_of(kStraight, {{-2.0, 1.3}, {0.0, 0.0}, 0.24}));
}

TEST(FirstInWay, tells_the_speed_along_the_way) {
  const auto found = ahead_of(kStraight, {{10.0, 0.0}, {1.2, 0.0}, 0.24});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->speed, 1.2, 1e-9);
}

TEST(FirstInWay, follows_the_bend_of_the_way) {
  const FleetVehicle turning = shuttle({{8.0, 0.0}, {8.0, 30.0}});
  EXPECT_TRUE(ahead_of(turning, {{8.0, 10.0}, {0, 0}, 0.24}));
  EXPECT_FALSE(ahead_of(turning, {{16.0, 0.0}, {0, 0}, 0.24})) << "straight on is not its way";
}

TEST(FirstInWay, counts_the_corner_that_the_body_cuts) {
  const FleetVehicle turning = shuttle({{8.0, 0.0}, {8.0, 30.0}});
  // Inside the bend, clear of the front's line by more than half the width: the chord sweeps it.
  EXPECT_TRUE(ahead_of(turning, {{6.3, 1.5}, {0, 0}, 0.24}));
}

TEST(FirstInWay, counts_the_rear_of_a_body_that_turns) {
  const FleetVehicle turning = shuttle({{0.5, 0.0}, {0.5, 2.0}, {-30.0, 2.0}});
  // Beside it, on the outer side of a turn about: the rear swings there, metres farther on.
  const Vec2 outside{-1.5, -1.5};
  EXPECT_TRUE(ahead_of(turning, {outside, {0, 0}, 0.24}));
  EXPECT_FALSE(ahead_of(kStraight, {outside, {0, 0}, 0.24}));
}

/// A car-following model that brakes evenly: the speed from which it stops within the gap. Notes
/// what it was asked.
struct EvenBraking {
  mutable std::vector<double> gaps;  ///< [m]

  SafeSpeeds speeds() const {
    return {[this](const FleetVehicle& vehicle, double gap) {
              gaps.push_back(gap);
              return std::sqrt(2.0 * vehicle.traits.decel * gap);
            },
            [this](const FleetVehicle& vehicle, double gap, double speed) {
              gaps.push_back(gap);
              return speed + std::sqrt(2.0 * vehicle.traits.decel * gap);
            }};
  }
};

FleetVehicle driving(double speed) {
  FleetVehicle vehicle = shuttle({{200.0, 0.0}});
  vehicle.speed = speed;
  vehicle.allowed_speed = 30.0;
  return vehicle;
}

TEST(PlanYield, leaves_the_yield_gap_before_somebody_who_stands) {
  const std::vector<PersonAhead> people{{{12.0, 0.0}, {0.0, 0.0}, 0.24}};
  for (const double gap : {0.0, 1.0, 3.0}) {
    Parameters parameters;
    parameters.yield_gap = gap;
    const EvenBraking own;
    FleetVehicle vehicle = driving(5.0);
    const auto found =
        first_in_way(vehicle, people, parameters.yield_margin, parameters.yield_horizon);
    ASSERT_TRUE(found);
    const auto order = plan_yield(vehicle, people, parameters, own.speeds(), 0.1);
    ASSERT_TRUE(order);
    EXPECT_FALSE(order->emergency);
    ASSERT_EQ(own.gaps.size(), 1U);
    EXPECT_NEAR(own.gaps[0], found->distance - gap, 1e-9);
  }
}

TEST(PlanYield, looks_as_far_as_it_takes_to_stop) {
  // From 15 m/s it takes 25 m at 4.5 m/s², and 15 m of driving on; the horizon is 15 m more.
  const Parameters parameters;
  for (const auto& [speed, at, minds] :
       {std::tuple{15.0, 53.0, true}, {15.0, 58.0, false}, {5.0, 21.0, true}, {5.0, 25.0, false}}) {
    const EvenBraking own;
    FleetVehicle vehicle = driving(speed);
    const std::vector<PersonAhead> people{{{at, 0.0}, {0.0, 0.0}, 0.24}};
    plan_yield(vehicle, people, parameters, own.speeds(), 0.1);
    EXPECT_EQ(!own.gaps.empty(), minds) << speed << " m/s, somebody at " << at << " m";
  }
}

TEST(PlanYield, creeps_after_seconds_and_not_after_steps) {
  const Parameters parameters;
  const std::vector<PersonAhead> people{{{0.8, 0.0}, {0.0, 0.0}, 0.24}};
  for (const double dt : {0.1, 0.5, 1.0}) {
    const EvenBraking own;
    FleetVehicle vehicle = driving(0.0);
    vehicle.commanded = 0.0;
    double time = 0.0;
    while (!vehicle.creeping && time < 100.0) {
      plan_yield(vehicle, people, parameters, own.speeds(), dt);
      time += dt;
    }
    EXPECT_NEAR(time, parameters.creep_after, dt + 1e-6) << dt;
  }
}

TEST(PlanYield, is_nothing_where_nobody_is_in_the_way) {
  const EvenBraking own;
  FleetVehicle vehicle = driving(5.0);
  vehicle.creeping = true;
  vehicle.held_up = 30.0;
  EXPECT_FALSE(plan_yield(vehicle, {}, Parameters(), own.speeds(), 0.1));
  EXPECT_FALSE(vehicle.creeping);
  EXPECT_EQ(vehicle.held_up, 0.0);
}

TEST(PlanYield, brakes_harder_than_it_likes_only_where_it_must) {
  const Parameters parameters;
  const EvenBraking own;
  const std::vector<PersonAhead> people{{{4.0, 0.0}, {0.0, 0.0}, 0.24}};
  FleetVehicle fast = driving(8.0), slow = driving(2.0);
  const auto hard = plan_yield(fast, people, parameters, own.speeds(), 0.5);
  ASSERT_TRUE(hard);
  EXPECT_TRUE(hard->emergency);
  EXPECT_NEAR(hard->speed, 8.0 - 9.0 * 0.5, 1e-9);
  const auto soft = plan_yield(slow, people, parameters, own.speeds(), 0.5);
  EXPECT_TRUE(!soft || !soft->emergency);
}

TEST(PlanYield, creeps_past_those_who_have_stepped_aside_once_it_was_slowed) {
  const Parameters parameters;
  const double side = 1.0 + 0.24;  // of the vehicle, and a body
  const auto order_after = [&](double slowed, double room) {
    const EvenBraking own;
    FleetVehicle vehicle = driving(0.0);
    vehicle.commanded = 0.0;
    vehicle.slowed = slowed;
    const std::vector<PersonAhead> people{{{1.0, side + room}, {0.0, 0.0}, 0.24}};
    return plan_yield(vehicle, people, parameters, own.speeds(), 0.1);
  };
  ASSERT_TRUE(order_after(3.0, 0.1));
  EXPECT_NEAR(order_after(3.0, 0.1)->speed, parameters.creep_speed, 1e-9);
  EXPECT_NEAR(order_after(3.0, 0.02)->speed, 0.0, 1e-9) << "too near";
  EXPECT_NEAR(order_after(0.0, 0.1)->speed, 0.0, 1e-9) << "nobody knows of it yet";
}

}  // namespace
}  // namespace pedzone
