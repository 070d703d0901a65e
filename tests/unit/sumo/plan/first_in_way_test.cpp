// Who is first in a vehicle's way.
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "shuttle.hpp"
#include "sumo/plan/yield_plan.hpp"

namespace pedzone {
namespace {

using test::shuttle;

constexpr double kMargin = 0.2, kLook = 20.0;

std::optional<Obstruction> ahead_of(const FleetVehicle& vehicle, const PersonAhead& person) {
  return first_in_way(vehicle, std::vector{person}, kMargin, kLook);
}

const FleetVehicle kStraight = shuttle({{30.0, 0.0}});

TEST(FirstInWay, is_the_person_before_the_bumper) {
  const auto found = ahead_of(kStraight, {{10.0, 0.0}, {0.0, 0.0}, 0.24});
  ASSERT_TRUE(found);
  // Contact when the front is at 10 - 0.24 - margin, found to 2 cm.
  EXPECT_LE(found->distance, 10.0 - 0.24 - kMargin + 1e-9);
  EXPECT_GE(found->distance, 10.0 - 0.24 - kMargin - 0.02);
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

/// A bus of 12 m about to turn left round a sharp corner at (3, 0).
FleetVehicle turning_bus() {
  FleetVehicle bus;
  bus.traits.length = 12.0;
  bus.traits.width = 2.5;
  bus.way = {{-12.0, 0.0}, {0.0, 0.0}, {3.0, 0.0}, {3.0, 30.0}};
  return bus;
}

TEST(FirstInWay, is_on_the_inner_side_where_a_long_body_cuts_the_corner) {
  EXPECT_TRUE(ahead_of(turning_bus(), {{-0.5, 3.5}, {0.0, 0.0}, 0.24}));
  EXPECT_FALSE(ahead_of(turning_bus(), {{-2.5, 5.5}, {0.0, 0.0}, 0.24}));
}

TEST(FirstInWay, is_where_the_rear_swings_out_behind_its_way) {
  // With 6 m on either side of the corner it is drawn 12 m long on a chord of 8.5 m.
  EXPECT_TRUE(ahead_of(turning_bus(), {{-4.4, -3.2}, {0.0, 0.0}, 0.24}));
  EXPECT_FALSE(ahead_of(turning_bus(), {{-4.4, -4.2}, {0.0, 0.0}, 0.24}));
}

TEST(FirstInWay, ignores_who_is_behind) {
  EXPECT_FALSE(ahead_of(kStraight, {{-6.0, 0.0}, {0.0, 0.0}, 0.24}));
}

TEST(FirstInWay, ignores_who_stands_close_beside_the_body) {
  EXPECT_FALSE(ahead_of(kStraight, {{-2.0, 1.3}, {0.0, 0.0}, 0.24}));
}

TEST(FirstInWay, ignores_who_squeezes_past_the_body_with_turned_shoulders) {
  EXPECT_FALSE(ahead_of(kStraight, {{-2.0, 1.15}, {0.0, 0.0}, 0.24}));
  EXPECT_TRUE(ahead_of(kStraight, {{0.5, 0.9}, {0.0, 0.0}, 0.24})) << "before the bumper";
  const FleetVehicle turning = shuttle({{0.5, 0.0}, {0.5, 2.0}, {-30.0, 2.0}});
  EXPECT_TRUE(ahead_of(turning, {{-1.5, -1.15}, {0.0, 0.0}, 0.24})) << "the rear swings there";
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

TEST(FirstInWay, is_beside_the_flank_of_one_that_turns_round_though_it_comes_back_nearer) {
  const FleetVehicle turning = shuttle({{1.0, 1.5}, {0.0, 3.2}, {-30.0, 3.2}});
  const PersonAhead inside{{-1.0, 1.7}, {0.0, 0.0}, 0.24};
  double touched = 0.0;
  while (body_after(turning, touched).signed_distance(inside.position) > inside.radius)
    touched += 0.01;
  ASSERT_LT(touched, 3.0) << "the flank comes over them at once";
  const auto found = ahead_of(turning, inside);
  ASSERT_TRUE(found);
  EXPECT_LT(found->distance, touched);
}

}  // namespace
}  // namespace pedzone
