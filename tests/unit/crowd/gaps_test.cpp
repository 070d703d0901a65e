// Gaps between vehicles, by hand: a street of 7 m, a person at its southern kerb.
#include "crowd/behaviour/gaps.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace pedzone::test {
namespace {

/// A car 1.8 m wide on the near lane (eastward) or the far one, `away` [m] from the line.
struct Car {
  bool near;
  double away, speed;
};

class Gaps : public ::testing::Test {
 protected:
  Gaps() {
    walk_.from = -3.9;
    walk_.to = 3.5;
    walk_.speed = 1.0;
    walk_.start_up = 1.0;
    walk_.margin = 2.0;
  }

  void add(const Car& car) {
    StreetVehicle seen;
    seen.vehicle = static_cast<std::uint32_t>(vehicles_.size());
    seen.direction = car.near ? 1 : -1;
    seen.front = -seen.direction * car.away;
    seen.length = 5.0;
    seen.speed = car.speed;
    const double middle = car.near ? -1.75 : 1.75;
    seen.low = middle - 0.9;
    seen.high = middle + 0.9;
    traffic_.vehicles.push_back(seen);
    vehicles_.emplace_back().key = vehicles_.size() + 1;
  }

  GapView look() const {
    return look_at_gap(traffic_.vehicles, vehicles_, walk_,
                       [this](std::uint32_t v) { return v != unseen_; });
  }

  CrossingWalk walk_;
  StreetTraffic traffic_;
  std::vector<VehicleState> vehicles_;
  std::uint32_t unseen_ = 99;
};

TEST_F(Gaps, are_enough_where_nobody_comes) {
  EXPECT_TRUE(look().enough);
  EXPECT_TRUE(std::isinf(look().next));
}

TEST_F(Gaps, on_the_near_lane_need_the_time_to_leave_that_lane_and_the_margin) {
  // Out of its width at t = -0.85 + 0.24 + 0.3: after 1 + 3.59 s; with the margin 6.59 s.
  add({true, 6.4 * 10.0, 10.0});
  EXPECT_FALSE(look().enough);
  traffic_.vehicles[0].front = -(6.8 * 10.0);
  EXPECT_TRUE(look().enough);
}

TEST_F(Gaps, on_the_far_lane_need_the_time_across_both) {
  add({false, 9.9 * 10.0, 10.0});  // out of the way after 1 + 7.09 s
  EXPECT_FALSE(look().enough);
  traffic_.vehicles[0].front = 10.3 * 10.0;
  EXPECT_TRUE(look().enough);
}

TEST_F(Gaps, roll_a_far_car_that_passes_before_the_person_is_there_does_not_count) {
  // Its rear is past after 1.7 s; the person comes after 4.2 s at the earliest.
  add({false, 10.0, 10.0});
  EXPECT_TRUE(look().enough);
  walk_.from = 0.0;  // there in 1.3 s
  EXPECT_FALSE(look().enough);
}

TEST_F(Gaps, tell_the_next_vehicle_that_counts_and_when_it_comes) {
  add({true, 50.0, 10.0});
  add({false, 30.0, 5.0});
  const GapView view = look();
  EXPECT_EQ(view.vehicle, vehicles_[0].key);
  EXPECT_NEAR(view.next, 5.0, 0.1);
}

TEST_F(Gaps, do_not_count_what_has_passed_or_stands_before_the_line_or_is_not_seen) {
  add({true, -6.0, 10.0});
  add({true, 3.0, 0.0});
  EXPECT_TRUE(look().enough);
  add({true, 10.0, 10.0});
  EXPECT_FALSE(look().enough);
  unseen_ = 2;
  EXPECT_TRUE(look().enough);
}

TEST_F(Gaps, are_barred_by_a_vehicle_that_stands_on_the_line) {
  add({true, -2.0, 0.0});
  EXPECT_TRUE(look().barred);
  EXPECT_FALSE(look().enough);
}

TEST_F(Gaps, count_a_slow_vehicle_as_one_that_may_speed_up) {
  add({true, 12.0, 2.0});  // 6 s at that speed, 3.3 s if it speeds up
  EXPECT_LT(look().next, 3.5);
}

TEST_F(Gaps, are_made_by_who_insists_where_the_driver_can_stop_in_comfort) {
  add({true, 45.0, 10.0});  // 15 m of reaction and 20 m of braking
  EXPECT_FALSE(look().enough);
  walk_.insists = true;
  EXPECT_TRUE(look().enough);
  traffic_.vehicles[0].front = -30.0;
  EXPECT_FALSE(look().enough);
}

TEST_F(Gaps, needed_are_width_over_speed_with_start_up_and_margin) {
  EXPECT_NEAR(critical_gap(walk_), 7.4 / 1.0 + 1.0 + 2.0, 1e-12);
}

TEST_F(Gaps, are_awaited_as_adams_found) {
  // Monte Carlo of Poisson traffic would do; here his formula at two places known by hand.
  EXPECT_DOUBLE_EQ(expected_wait(0.0, 8.0), 0.0);
  EXPECT_NEAR(expected_wait(0.1, 10.0), (std::exp(1.0) - 2.0) / 0.1, 1e-9);
  EXPECT_DOUBLE_EQ(expected_wait(10.0, 100.0), 3600.0);
}

class OnTheWay : public Gaps {
 protected:
  OnTheWay() {
    walk_.start_up = 0.0;
    walk_.margin = 0.3;
  }
  Passage pass(double fastest = 1.5) const {
    return pass_vehicles(traffic_, walk_, fastest, [](std::uint32_t) { return true; });
  }
};

TEST_F(OnTheWay, people_walk_on_where_they_are_past_in_time) {
  add({false, 90.0, 10.0});
  EXPECT_DOUBLE_EQ(pass().hurry, 1.0);
  EXPECT_TRUE(std::isinf(pass().room));
}

TEST_F(OnTheWay, they_hurry_where_that_is_enough) {
  walk_.from = -1.0;
  add({true, 200.0, 10.0});  // it is where vehicles drive
  add({false, 40.0, 10.0});  // 4.2 s of walking, 3.6 s left
  EXPECT_GT(pass().hurry, 1.1);
  EXPECT_LT(pass().hurry, 1.4);
  EXPECT_TRUE(std::isinf(pass().room));
}

TEST_F(OnTheWay, they_stand_between_the_lanes_where_it_is_not) {
  walk_.from = -1.0;
  add({false, 20.0, 10.0});
  EXPECT_DOUBLE_EQ(pass().hurry, 1.0);
  EXPECT_NEAR(pass().room, 0.85 - 0.54 + 1.0, 1e-9);
}

TEST_F(OnTheWay, they_wait_for_a_gap_as_at_the_kerb_where_no_vehicle_drives_yet) {
  walk_.from = -1.0;  // the near lane is full of parked cars
  walk_.margin = 2.0;
  add({true, 5.0, 0.0});
  add({false, 50.0, 10.0});  // 4.2 s of walking, 5 s left
  EXPECT_FALSE(pass().committed);
  EXPECT_NEAR(pass().room, 0.85 - 0.54 + 1.0, 1e-9);
  EXPECT_DOUBLE_EQ(pass().hurry, 1.0);
  add({true, 200.0, 10.0});
  EXPECT_TRUE(pass().committed);
  EXPECT_TRUE(std::isinf(pass().room));
}

TEST_F(OnTheWay, people_walk_past_the_end_of_a_parked_car) {
  walk_.from = -1.0;
  add({false, -5.5, 0.0});  // its rear is 0.5 m away
  EXPECT_TRUE(std::isinf(pass().room));
  EXPECT_TRUE(std::isinf(pass().standing));
  add({false, -5.2, 0.0});
  EXPECT_NEAR(pass().standing, 0.85 - 0.54 + 1.0, 1e-9);
}

TEST_F(OnTheWay, people_walk_between_parked_cars_to_where_their_line_leads) {
  walk_.from = -1.0;
  add({false, -3.0, 0.0});  // stands on the line
  EXPECT_TRUE(pass().barred());
  walk_.drift = 5.5;  // 2 m by the car's near side, 4.6 m by its far one
  EXPECT_TRUE(pass().barred());
  walk_.drift = 7.0;  // 2.5 m, and it ends 2 m away
  EXPECT_FALSE(pass().barred());
  EXPECT_TRUE(std::isinf(pass().room));
}

TEST_F(OnTheWay, whoever_has_waited_for_long_steps_before_one_that_can_stop) {
  walk_.from = 0.3;
  add({false, 18.0, 6.0});
  EXPECT_LT(pass().room, 0.1);
  walk_.insists = true;
  EXPECT_TRUE(std::isinf(pass().room));
  add({false, 10.0, 6.0});
  EXPECT_LT(pass().room, 0.1);
}

TEST_F(OnTheWay, whoever_stands_before_one_stays_there) {
  walk_.from = 0.85 - 0.24 - 0.2;  // 0.2 m beside where it drives
  add({false, 10.0, 10.0});
  EXPECT_DOUBLE_EQ(pass().hurry, 1.0);
  EXPECT_DOUBLE_EQ(pass().room, 0.0);
}

TEST_F(OnTheWay, whoever_is_in_the_way_of_one_runs) {
  walk_.from = 1.0;
  add({false, 10.0, 10.0});
  EXPECT_DOUBLE_EQ(pass().hurry, 1.5);
}

}  // namespace
}  // namespace pedzone::test
