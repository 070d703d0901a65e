// Hand-computed cases: a vehicle of 4 by 2 m, a person of radius 0.25 m.
#include "conflict/approach.hpp"

#include <gmock/gmock.h>

namespace pedzone {
namespace {

using ::testing::DoubleNear;
using ::testing::Eq;
using ::testing::Optional;

constexpr double kExact = 1e-9;

/// The person at (x, y) from the vehicle's centre with velocity (vx, vy), the vehicle driving at
/// `speed`.
Approach approach(double x, double y, double vx, double vy, double speed) {
  Approach a;
  a.at = {x, y};
  a.velocity = {vx - speed, vy};
  a.speed = speed;
  a.sizes = {2.0, 1.0, 0.25};
  return a;
}

/// The same seen by a vehicle that reverses.
Approach reversed(Approach a) {
  a.at.x() *= -1.0;
  a.velocity.x() *= -1.0;
  a.speed *= -1.0;
  return a;
}

TEST(Clearance, is_the_room_between_rim_and_rectangle) {
  EXPECT_NEAR(clearance(approach(5, 0, 0, 0, 0)), 2.75, kExact);             // ahead
  EXPECT_NEAR(clearance(approach(0, -3, 0, 0, 0)), 1.75, kExact);            // beside
  EXPECT_NEAR(clearance(approach(5, 5, 0, 0, 0)), 5.0 - 0.25, kExact);       // 3-4-5 to the corner
  EXPECT_NEAR(clearance(approach(1.9, 0.0, 0, 0, 0)), -0.1 - 0.25, kExact);  // overlapping
}

TEST(TimeToContact, head_on_is_gap_over_both_speeds) {
  // Gap 12 - 2 - 0.25 = 9.75 m, closing at 5 + 1.5.
  EXPECT_THAT(time_to_contact(approach(12, 0, -1.5, 0, 5)), Optional(DoubleNear(1.5, kExact)));
}

TEST(TimeToContact, following_is_gap_over_the_difference_of_speeds) {
  EXPECT_THAT(time_to_contact(approach(8.25, 0.5, 1, 0, 4)), Optional(DoubleNear(2.0, kExact)));
  EXPECT_THAT(time_to_contact(approach(8.25, 0.5, 4, 0, 4)), Eq(std::nullopt));
  EXPECT_THAT(time_to_contact(approach(8.25, 0.5, 5, 0, 4)), Eq(std::nullopt));
}

TEST(TimeToContact, at_a_right_angle_is_when_the_front_reaches_a_person_in_its_way) {
  // In the way from |y| = 1.25 on: (3.25 - 1.25) / 1 = 2 s. Then the front is at 2 + 4·2 = 10 m.
  EXPECT_THAT(time_to_contact(approach(10.25, -3.25, 0, 1, 4)),
              Optional(DoubleNear(2.0, 0.1)));  // meets the corner: up to the radius later
  // One metre farther ahead the front meets it at (11.25 - 2 - 0.25) / 4.
  EXPECT_THAT(time_to_contact(approach(11.25, -3.25, 0, 1, 4)), Optional(DoubleNear(2.25, kExact)));
  // Into the vehicle's side: beside it from y = -1.25 on, at 2 s.
  EXPECT_THAT(time_to_contact(approach(8, -3.25, 0, 1, 4)), Optional(DoubleNear(2.0, kExact)));
  // The rear has passed by then (x < -2.25), or the person has left the way at 4.5 s.
  EXPECT_THAT(time_to_contact(approach(5.7, -3.25, 0, 1, 4)), Eq(std::nullopt));
  EXPECT_THAT(time_to_contact(approach(20.5, -3.25, 0, 1, 4)), Eq(std::nullopt));
}

TEST(TimeToContact, meets_corners_with_the_disc_and_not_with_its_square) {
  // Past the corner (2, 1) at a distance of 0.24 and 0.26 m, on a line at 45°.
  const double side = std::sqrt(0.5);
  const auto past = [&](double distance) {
    Approach a = approach(0, 0, 0, 0, 0);
    a.at = Vec2(2, 1) + distance * Vec2(side, side) + 3.0 * Vec2(side, -side);
    a.velocity = Vec2(-side, side);
    return time_to_contact(a);
  };
  EXPECT_THAT(past(0.24), Optional(DoubleNear(3.0 - std::sqrt(0.25 * 0.25 - 0.24 * 0.24), kExact)));
  EXPECT_THAT(past(0.26), Eq(std::nullopt));
}

TEST(TimeToContact, with_a_parked_vehicle_is_the_way_of_the_person) {
  EXPECT_THAT(time_to_contact(approach(0, 4.25, 0, -1.5, 0)), Optional(DoubleNear(2.0, kExact)));
  EXPECT_THAT(time_to_contact(approach(0, 4.25, 1.5, 0, 0)), Eq(std::nullopt));
}

TEST(TimeToContact, of_a_standing_person_is_the_way_of_the_vehicle) {
  EXPECT_THAT(time_to_contact(approach(12.25, 0.9, 0, 0, 5)), Optional(DoubleNear(2.0, kExact)));
  EXPECT_THAT(time_to_contact(approach(12.25, 1.3, 0, 0, 5)), Eq(std::nullopt));
}

TEST(TimeToContact, is_zero_where_they_touch_and_none_where_they_part) {
  EXPECT_THAT(time_to_contact(approach(2.1, 0, 3, 0, 0)), Optional(Eq(0.0)));
  EXPECT_THAT(time_to_contact(approach(2.25, 0, 1, 0, 0)), Eq(std::nullopt));  // only grazes
  EXPECT_THAT(time_to_contact(approach(2.25, 0, 0, 1, 0)), Eq(std::nullopt));
  EXPECT_THAT(time_to_contact(approach(2.25, 0, -1, 0, 0)), Optional(Eq(0.0)));
  EXPECT_THAT(time_to_contact(approach(4, 3, 2, 1, 0)), Eq(std::nullopt));
}

TEST(TimeToContact, is_the_same_for_a_vehicle_that_reverses) {
  for (const Approach& a : {approach(12, 0, -1.5, 0, 5), approach(11.25, -3.25, 0, 1, 4)}) {
    EXPECT_EQ(time_to_contact(reversed(a)), time_to_contact(a));
    EXPECT_EQ(deceleration_to_avoid(reversed(a)), deceleration_to_avoid(a));
  }
}

TEST(ContactPoint, lies_on_the_rectangle) {
  const Approach a = approach(11.25, -3.25, 0, 1, 4);  // 2.25 s: the person at y = -1
  EXPECT_LT((contact_point(a, 2.25) - Vec2(2, -1)).norm(), kExact);
}

TEST(DecelerationToAvoid, following_is_half_the_squared_difference_over_the_gap) {
  // Gap 6 m, 3 m/s faster.
  EXPECT_THAT(deceleration_to_avoid(approach(8.25, 0, 1, 0, 4)),
              Optional(DoubleNear(0.5 * 9.0 / 6.0, kExact)));
}

TEST(DecelerationToAvoid, before_a_standing_person_is_half_the_squared_speed_over_the_gap) {
  EXPECT_THAT(deceleration_to_avoid(approach(12.25, 0, 0, 0, 5)),
              Optional(DoubleNear(0.5 * 25.0 / 10.0, kExact)));
}

TEST(DecelerationToAvoid, head_on_lets_the_vehicle_stand_when_they_meet) {
  // Braking with a from 5 m/s it stands after 5/a s and 12.5/a m; in that time the person has come
  // 5/a·1.5 m. Together the gap of 9.75 m.
  EXPECT_THAT(deceleration_to_avoid(approach(12, 0, -1.5, 0, 5)),
              Optional(DoubleNear((12.5 + 7.5) / 9.75, kExact)));
}

TEST(DecelerationToAvoid, crossing_lets_the_person_leave_the_way_first) {
  // It leaves the way, |y| = 1.25, after 4.5 s. Until then the front may go 16 m: 2 (4 -
  // 16/4.5)/4.5.
  const Approach leaves = approach(18.25, -3.25, 0, 1, 4);
  ASSERT_THAT(time_to_contact(leaves), Optional(DoubleNear(4.0, kExact)));
  EXPECT_THAT(deceleration_to_avoid(leaves),
              Optional(DoubleNear(2.0 * (4.0 - 16.0 / 4.5) / 4.5, kExact)));
  // Slow: the vehicle would have to stop before it, ½ v²/gap, long before the person has left.
  EXPECT_THAT(deceleration_to_avoid(approach(6.25, -1.5, 0, 0.2, 4)),
              Optional(DoubleNear(0.5 * 16.0 / 4.0, kExact)));
}

TEST(DecelerationToAvoid, is_none_where_braking_is_not_needed_or_does_not_help) {
  EXPECT_EQ(deceleration_to_avoid(approach(8.25, 3, 0, 0, 4)), std::nullopt);   // beside its way
  EXPECT_EQ(deceleration_to_avoid(approach(0, -3.25, 4, 1, 4)), std::nullopt);  // into its side
  EXPECT_EQ(deceleration_to_avoid(approach(0, -3.25, 0, 1, 0)), std::nullopt);  // parked
  EXPECT_EQ(deceleration_to_avoid(approach(2.1, 0, 0, 0, 4)), std::nullopt);    // touching
  EXPECT_EQ(deceleration_to_avoid(approach(-5, 0, 3, 0, 1)), std::nullopt);  // runs into its rear
}

TEST(ClosestOnWay, finds_what_lies_between_two_steps) {
  const Approach a = approach(0, 0, 0, 0, 0);
  // Through the rectangle from one side to the other: the rim (less kTouch) touches after
  // 5 - 1 - 0.24 of 10 m.
  const Closest through = closest_on_way(a.sizes, {0, -5}, {0, 5});
  EXPECT_THAT(through.touch, Optional(DoubleNear(3.76 / 10.0, kExact)));
  EXPECT_NEAR(through.clearance, -1.0 - 0.25, kExact);  // over the middle
  // Along a side and 0.6 m deep, then out by the front: there it is deepest at 45° to the corner.
  EXPECT_NEAR(closest_on_way(a.sizes, {0, 0.4}, {5, 0.4}).clearance, -0.6 - 0.25, kExact);
  EXPECT_NEAR(closest_on_way(a.sizes, {0, 2}, {3, -1}).clearance, -0.5 - 0.25, kExact);
  // Past the corner (2, 1): the line x + y = 4 is 1/√2 from it.
  const Closest past = closest_on_way(a.sizes, {4, 0}, {0, 4});
  EXPECT_EQ(past.touch, std::nullopt);
  EXPECT_NEAR(past.clearance, std::sqrt(0.5) - 0.25, kExact);
}

}  // namespace
}  // namespace pedzone
