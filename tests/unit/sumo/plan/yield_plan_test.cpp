// How fast a vehicle is told to drive before people.
#include "sumo/plan/yield_plan.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <tuple>
#include <vector>

#include "shuttle.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

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
  FleetVehicle vehicle = test::shuttle({{200.0, 0.0}});
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

TEST(PlanYield, leaves_more_to_one_that_comes_towards_it_in_the_step) {
  const Parameters parameters;
  for (const double dt : {0.1, 1.0}) {
    const EvenBraking own;
    for (const double comes : {0.0, 1.2}) {
      FleetVehicle vehicle = driving(5.0);
      plan_yield(vehicle, std::vector<PersonAhead>{{{12.0, 0.0}, {-comes, 0.0}, 0.24}}, parameters,
                 own.speeds(), dt);
    }
    ASSERT_EQ(own.gaps.size(), 2U);
    EXPECT_NEAR(own.gaps[1], own.gaps[0] - 1.2 * dt, 1e-9);
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
  vehicle.blocked_time = 30.0;
  EXPECT_FALSE(plan_yield(vehicle, {}, Parameters(), own.speeds(), 0.1));
  EXPECT_FALSE(vehicle.creeping);
  EXPECT_EQ(vehicle.blocked_time, 0.0);
}

/// What a vehicle of 8 m/s is told before one person, in steps of `dt` [s].
std::optional<YieldOrder> told(const PersonAhead& person, double dt, double speed = 8.0) {
  const EvenBraking own;
  FleetVehicle vehicle = driving(speed);
  return plan_yield(vehicle, std::vector{person}, Parameters(), own.speeds(), dt);
}

TEST(PlanYield, brakes_harder_than_it_likes_only_where_it_must) {
  for (const double dt : {0.1, 0.5}) {
    const auto hard = told({{3.0, 0.0}, {0.0, 0.0}, 0.24}, dt);
    ASSERT_TRUE(hard);
    EXPECT_TRUE(hard->emergency);
    EXPECT_LT(hard->speed, 8.0 - 4.5 * dt);
    EXPECT_GE(hard->speed, 8.0 - 9.0 * dt - 1e-9);
    const auto soft = told({{3.0, 0.0}, {0.0, 0.0}, 0.24}, dt, 2.0);
    EXPECT_TRUE(!soft || !soft->emergency);
  }
}

TEST(PlanYield, asks_for_no_more_than_comfort_where_only_the_gap_would_be_lost) {
  // 7.1 m to stop from 8 m/s at 4.5 m/s²: without a contact, with less than yieldGap left.
  const auto order = told({{7.6, 0.0}, {0.0, 0.0}, 0.24}, 0.1);
  ASSERT_TRUE(order);
  EXPECT_FALSE(order->emergency);
  EXPECT_NEAR(order->speed, 8.0 - 4.5 * 0.1, 1e-9);
}

TEST(PlanYield, brakes_hard_where_the_way_in_its_steps_is_too_long) {
  // From 8 m/s at 4.5 m/s² in steps of 1 s: 3.5 m if its speed changes at once, 7.5 m if evenly.
  const SafeSpeeds none{[](const FleetVehicle&, double) { return 0.0; },
                        [](const FleetVehicle&, double, double) { return 0.0; }};
  const auto brakes_hard = [&](double distance, bool ballistic) {
    FleetVehicle vehicle = driving(8.0);
    vehicle.traits.ballistic = ballistic;
    const std::vector<PersonAhead> people{{{distance, 0.0}, {0.0, 0.0}, 0.24}};
    return plan_yield(vehicle, people, Parameters(), none, 1.0)->emergency;
  };
  EXPECT_FALSE(brakes_hard(6.0, false));
  EXPECT_TRUE(brakes_hard(6.0, true));
  EXPECT_FALSE(brakes_hard(8.5, true));
}

TEST(PlanYield, does_not_brake_hard_for_who_will_be_across) {
  const PersonAhead stays{{4.0, 0.9}, {0.0, 0.0}, 0.24}, leaves{{4.0, 0.9}, {0.0, 2.0}, 0.24};
  EXPECT_TRUE(told(stays, 0.1)->emergency);
  EXPECT_FALSE(told(leaves, 0.1)->emergency);
}

TEST(PlanYield, does_not_brake_hard_for_who_walks_against_its_side) {
  const auto order = told({{-1.0, 1.6}, {0.0, -1.3}, 0.24}, 0.1);
  EXPECT_TRUE(!order || !order->emergency);
}

TEST(PlanYield, brakes_hard_for_who_stands_where_its_flank_will_swing) {
  // Its front comes past the person; its flank cuts the corner that follows.
  const auto told_before = [](const std::vector<Vec2>& way) {
    FleetVehicle vehicle = test::shuttle(way);
    vehicle.speed = 6.0;
    vehicle.allowed_speed = 30.0;
    const double beside = 0.5 * vehicle.traits.width + 0.24 + 0.05;
    const std::vector<PersonAhead> people = {{{0.2, -beside}, {0.0, 0.0}, 0.24}};
    return plan_yield(vehicle, people, Parameters(), EvenBraking().speeds(), 0.1);
  };
  const auto turns = told_before({{1.0, 0.0}, {20.0, -11.0}});
  ASSERT_TRUE(turns);
  EXPECT_TRUE(turns->emergency);
  const auto straight = told_before({{200.0, 0.0}});
  EXPECT_TRUE(!straight || !straight->emergency);
}

TEST(PlanYield, edges_past_who_is_beside_it_and_does_not_get_away) {
  Parameters parameters;
  const EvenBraking own;
  FleetVehicle vehicle = test::shuttle({{1.0, 0.0}, {1.0, 200.0}});  // its tail will swing
  vehicle.allowed_speed = 10.0;
  vehicle.commanded = 0.0;
  std::vector<PersonAhead> people{{{-0.8, 1.2}, {0.0, 0.0}, 0.24}};
  double most = 0.0, time = 0.0;
  const auto wait_until = [&](double end) {
    for (; time < end; time += 0.5) {
      const auto order = plan_yield(vehicle, people, parameters, own.speeds(), 0.5);
      most = std::max(most, order ? order->speed : vehicle.allowed_speed);
    }
  };
  wait_until(59.0);
  EXPECT_EQ(most, 0.0);
  wait_until(62.0);
  EXPECT_NEAR(most, kSqueezeSpeed, 1e-9);
  most = 0.0;
  people.push_back({{0.4, 0.0}, {0.0, 0.0}, 0.24});
  wait_until(70.0);
  EXPECT_EQ(most, 0.0) << "not past who is before it";
  people = {{{2.0, 0.0}, {0.0, 0.0}, 0.24}};
  wait_until(71.0);
  EXPECT_GT(most, kSqueezeSpeed) << "it creeps as before where it may";
  parameters.creep_after = 200.0;
  people = {{{-0.8, 1.2}, {0.0, 0.0}, 0.24}};
  most = 0.0;
  wait_until(80.0);
  EXPECT_EQ(most, 0.0) << "not before it creeps";
}

TEST(PlanYield, brakes_as_hard_as_it_needs_to) {
  // From 8 m/s, contact after 4.76 m: 8² / (2 · 4.76) = 6.7 m/s², less what SUMO's steps add.
  const auto order = told({{5.0, 0.0}, {0.0, 0.0}, 0.24}, 0.1);
  ASSERT_TRUE(order);
  EXPECT_TRUE(order->emergency);
  EXPECT_NEAR((8.0 - order->speed) / 0.1, 6.5, 0.6);
}

/// A vehicle 10 m before a junction of 14 m that others come to as well.
FleetVehicle before_junction(bool shared) {
  FleetVehicle vehicle = driving(5.0);
  vehicle.junction = {0, 10.0, 24.0, shared};
  return vehicle;
}

TEST(PlanYield, stays_out_of_a_junction_in_which_it_would_have_to_stand) {
  for (const double at : {16.0, 25.0}) {
    const std::vector<PersonAhead> people{{{at, 0.0}, {0.0, 0.0}, 0.24}};
    for (const bool shared : {true, false}) {
      const EvenBraking own;
      FleetVehicle vehicle = before_junction(shared);
      plan_yield(vehicle, people, Parameters(), own.speeds(), 0.1);
      EXPECT_EQ(testing::Value(own.gaps, testing::Contains(10.0)), shared) << at << " m";
    }
  }
}

TEST(PlanYield, enters_a_junction_that_it_can_leave_or_is_in_or_after_waiting) {
  const EvenBraking own;
  const std::vector<PersonAhead> beyond{{{31.0, 0.0}, {0.0, 0.0}, 0.24}},
      inside{{{16.0, 0.0}, {0.0, 0.0}, 0.24}};
  FleetVehicle leaves = before_junction(true);  // 24 + 4 + 1 m have it out of it
  plan_yield(leaves, beyond, Parameters(), own.speeds(), 0.1);
  FleetVehicle is_in = before_junction(true);
  is_in.junction.begin = 0.0;
  plan_yield(is_in, inside, Parameters(), own.speeds(), 0.1);
  FleetVehicle creeps = before_junction(true);
  creeps.speed = 0.0;
  creeps.creeping = true;
  creeps.commanded = 0.0;
  creeps.blocked_time = 30.0;
  plan_yield(creeps, inside, Parameters(), own.speeds(), 0.1);
  EXPECT_THAT(own.gaps, testing::Not(testing::Contains(10.0)));
}

TEST(PlanYield, claims_no_room_while_traffic_holds_it) {
  const EvenBraking own;
  const std::vector<PersonAhead> people{{{6.0, 0.0}, {0.0, 0.0}, 0.24}};
  for (const double commanded : {0.0, 2.0}) {
    FleetVehicle vehicle = driving(0.0);
    for (int step = 0; step < 50; ++step) {
      vehicle.commanded = commanded;  // and it still stands
      plan_yield(vehicle, people, Parameters(), own.speeds(), 0.1);
    }
    EXPECT_EQ(vehicle.claim > 0.0, commanded == 0.0) << commanded;
    EXPECT_EQ(vehicle.blocked_time > 0.0, commanded == 0.0) << commanded;
  }
}

TEST(PlanYield, claims_no_room_in_a_junction_that_it_stays_out_of) {
  const EvenBraking own;
  const std::vector<PersonAhead> people{{{6.0, 0.0}, {0.0, 0.0}, 0.24}};
  for (const bool shared : {true, false}) {
    FleetVehicle vehicle = before_junction(shared);
    vehicle.junction.begin = 0.1;
    vehicle.speed = vehicle.commanded = 0.0;
    for (int step = 0; step < 50; ++step)
      plan_yield(vehicle, people, Parameters(), own.speeds(), 0.1);
    EXPECT_EQ(vehicle.claim > 0.0, !shared);
    for (int step = 0; step < 160; ++step)
      plan_yield(vehicle, people, Parameters(), own.speeds(), 0.1);
    EXPECT_TRUE(vehicle.creeping);
    EXPECT_GT(vehicle.claim, 0.0) << "it enters";
  }
}

/// Held up by somebody until it claims room, who then leaves it; what it claims [m] after `later`
/// [s]. `share`: of what it is told it drives.
double claim_after(double later, double share, double accel = 2.6) {
  const EvenBraking own;
  FleetVehicle vehicle = driving(0.0);
  vehicle.traits.accel = accel;
  vehicle.commanded = 0.0;
  const std::vector<PersonAhead> nobody, people{{{1.0, 0.0}, {0.0, 0.0}, 0.24}};
  for (double time = 0.0; time < 3.0; time += 0.1) {
    plan_yield(vehicle, people, Parameters(), own.speeds(), 0.1);
  }
  EXPECT_GT(vehicle.claim, 0.0);
  for (double time = 0.0; time < later; time += 0.1) {
    const auto order = plan_yield(vehicle, nobody, Parameters(), own.speeds(), 0.1);
    vehicle.commanded = order ? order->speed : -1.0;
    vehicle.speed = share * (order ? order->speed : vehicle.allowed_speed);
  }
  return vehicle.claim;
}

TEST(PlanYield, claims_the_room_that_people_made_until_it_has_driven_off) {
  EXPECT_GT(claim_after(0.3, 1.0), 0.0) << "they would step in again";
  EXPECT_EQ(claim_after(2.5, 1.0), 0.0) << "it drives";
  EXPECT_EQ(claim_after(1.0, 0.0), 0.0) << "traffic holds it";
  EXPECT_GT(claim_after(1.0, 0.99), 0.0);
  EXPECT_GT(claim_after(0.5, 0.0, 0.1), 0.0) << "told so little, nobody knows what holds it";
  EXPECT_EQ(claim_after(1.5, 0.0, 0.1), 0.0) << "nobody waits for it for ever";
}

TEST(PlanYield, drives_slowly_past_who_squeezes_past_with_turned_shoulders) {
  const auto speed_beside = [](const Vec2& place, double at_first = 0.0) {
    const EvenBraking own;
    FleetVehicle vehicle = driving(at_first);
    std::optional<YieldOrder> order;
    for (int step = 0; step < 20; ++step) {  // it gathers speed; where it is stays the same
      order = plan_yield(vehicle, std::vector{PersonAhead{place, {0.0, 0.0}, 0.24}}, Parameters(),
                         own.speeds(), 0.1);
      vehicle.speed += vehicle.traits.accel * 0.1;
      if (order) vehicle.speed = vehicle.commanded = order->speed;
    }
    return vehicle.speed;
  };
  EXPECT_NEAR(speed_beside({-2.0, 1.0 + 0.15}), kSqueezeSpeed, 1e-9);
  EXPECT_GT(speed_beside({-2.0, 1.0 + 0.25}), 4.0) << "beside it with straight shoulders";
  EXPECT_GT(speed_beside({-5.0, 0.0}), 4.0) << "behind it";
  EXPECT_GT(speed_beside({-2.0, 1.0 + 0.15}, 8.0), 8.0) << "who stands at the kerb";
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
    std::optional<YieldOrder> order;
    for (int step = 0; step < 20; ++step) {  // it gathers speed; where it is stays the same
      order = plan_yield(vehicle, people, parameters, own.speeds(), 0.1);
      if (!order) break;
      vehicle.speed = vehicle.commanded = order->speed;
      vehicle.slowed = slowed;
    }
    return order;
  };
  ASSERT_TRUE(order_after(3.0, 0.1));
  EXPECT_NEAR(order_after(3.0, 0.1)->speed, parameters.creep_speed, 1e-9);
  EXPECT_NEAR(order_after(3.0, 0.02)->speed, 0.0, 1e-9) << "too near";
  EXPECT_NEAR(order_after(0.0, 0.1)->speed, 0.0, 1e-9) << "nobody knows of it yet";
}

TEST(PlanYield, drives_slowly_past_those_who_have_turned_their_shoulders_for_it) {
  const auto speed_after = [](double narrower, double slowed = 3.0) {
    const EvenBraking own;
    FleetVehicle vehicle = driving(0.0);
    PersonAhead person{{0.3, 1.0 + 0.2}, {0.0, 0.0}, 0.24};
    person.narrower = narrower;
    for (int step = 0; step < 20; ++step) {  // it gathers speed; where it is stays the same
      vehicle.slowed = slowed;
      const auto order = plan_yield(vehicle, std::vector{person}, Parameters(), own.speeds(), 0.1);
      vehicle.speed = vehicle.commanded = order ? order->speed : 10.0;
    }
    return vehicle.speed;
  };
  EXPECT_NEAR(speed_after(0.12), kSqueezeSpeed, 1e-9);
  EXPECT_NEAR(speed_after(0.05), 0.0, 1e-9) << "not enough";
  EXPECT_NEAR(speed_after(0.0), 0.0, 1e-9);
  EXPECT_NEAR(speed_after(0.12, 0.0), 0.0, 1e-9) << "nobody knows of it yet";
}

}  // namespace
}  // namespace pedzone
