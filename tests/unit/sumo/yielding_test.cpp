// Who is in a vehicle's way.
#include "sumo/yielding.hpp"

#include <gmock/gmock.h>

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

TEST(Body, distance_is_negative_inside) {
  const Body body{{0, 0}, {1, 0}, 2.0, 1.0};
  EXPECT_NEAR(body.distance({0.0, 0.5}), -0.5, 1e-12);
  EXPECT_NEAR(body.distance({5.0, 0.0}), 3.0, 1e-12);
  EXPECT_NEAR(body.distance({5.0, 5.0}), 5.0, 1e-12);
}

}  // namespace
}  // namespace pedzone
