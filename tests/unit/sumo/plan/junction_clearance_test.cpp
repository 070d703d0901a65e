// Who keeps a junction clear for whom, where people have held one of them.
#include "sumo/plan/junction_clearance.hpp"

#include <gmock/gmock.h>

#include "sumo/plan/yielding.hpp"

namespace pedzone {
namespace {

/// One from the south, 6 m before a junction round the origin, and one inside it that goes east.
class JunctionClearance : public testing::Test {
 protected:
  JunctionClearance() {
    FleetVehicle& comes = vehicles_[0];
    comes.id = "comes";
    comes.front = {0.0, -6.0};
    comes.heading = kPi / 2.0;
    comes.way = {{0.0, -11.0}, {0.0, -6.0}, {0.0, 60.0}};
    comes.lane = 1;
    comes.junction = {.junction = 7, .begin = 2.0, .end = 10.0};
    comes.speed = 4.0;
    comes.velocity = {0.0, 4.0};
    comes.commanded = 4.0;
    FleetVehicle& inside = vehicles_[1];
    inside.id = "inside";
    inside.front = {1.0, 0.0};
    inside.way = {{-4.0, 0.0}, {1.0, 0.0}, {60.0, 0.0}};
    inside.lane = 2;
    inside.junction = {.junction = 7, .begin = -5.0, .end = 3.0};
    inside.speed = 2.0;
    inside.velocity = {2.0, 0.0};
    for (FleetVehicle& vehicle : vehicles_) vehicle.allowed_speed = 10.0;
  }

  std::optional<Obstruction> first() const {
    return first_in_junction(vehicles_[0], in_junctions(vehicles_));
  }

  std::vector<FleetVehicle> vehicles_{2};
};

TEST_F(JunctionClearance, is_kept_for_one_that_drives_through) {
  const auto ahead = first();
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(ahead->distance, 2.0, 1e-9) << "up to its line";
  EXPECT_NEAR(ahead->speed, 0.0, 1e-9) << "it goes across";
}

TEST_F(JunctionClearance, is_not_kept_for_one_elsewhere) {
  const std::vector<FleetVehicle> before = vehicles_;
  vehicles_[1].junction.junction = 8;
  EXPECT_FALSE(first()) << "another junction";
  vehicles_ = before;
  vehicles_[1].junction.begin = 1.0;
  EXPECT_FALSE(first()) << "it has not come in";
  vehicles_[1].junction.begin = -0.9;
  EXPECT_FALSE(first()) << "so far in it is in nobody's way";
  vehicles_ = before;
  vehicles_[1].speed = 0.0;
  EXPECT_FALSE(first()) << "it stands: SUMO's matter";
  vehicles_ = before;
  vehicles_[1].lane = vehicles_[0].lane;
  EXPECT_FALSE(first()) << "before it on its lane: SUMO's matter";
  vehicles_ = before;
  vehicles_[1].front.x() = 30.0;
  vehicles_[1].way = {{25.0, 0.0}, {30.0, 0.0}, {60.0, 0.0}};
  EXPECT_FALSE(first()) << "past its way";
}

TEST_F(JunctionClearance, is_kept_by_one_that_comes_for_one_that_people_hold) {
  vehicles_[1].speed = 0.0;
  vehicles_[1].commanded = 0.0;
  EXPECT_TRUE(first()) << "it would have driven on";
  vehicles_[0].junction.begin = -0.9;
  EXPECT_TRUE(first()) << "it is as good as outside";
}

TEST_F(JunctionClearance, is_kept_by_one_inside_from_the_body_of_one_that_stands_and_could_go_on) {
  vehicles_[1].speed = 0.0;
  vehicles_[0].junction.begin = -2.0;
  const auto ahead = first();
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(ahead->distance, 6.0 - 0.9 - 0.5, 0.05) << "its flank, and half a metre between";
  vehicles_[1].front.x() = -3.0;
  vehicles_[1].way = {{-8.0, 0.0}, {-3.0, 0.0}, {60.0, 0.0}};
  EXPECT_FALSE(first()) << "nobody waits for where it might get to";
}

TEST_F(JunctionClearance, is_not_kept_where_two_inside_would_wait_for_each_other) {
  vehicles_[1].speed = 0.0;
  FleetVehicle& turns = vehicles_[0];
  turns.front = {3.0, 0.0};
  turns.way = {{3.0, -5.0}, {3.0, 0.0}, {-60.0, 0.0}};
  turns.junction.begin = -2.0;
  EXPECT_FALSE(first());
}

TEST_F(JunctionClearance, is_sumos_matter_where_people_held_nobody) {
  vehicles_[0].commanded = -1.0;
  EXPECT_FALSE(first());
  vehicles_[0].left_alone = 4.9;
  EXPECT_TRUE(first()) << "let go a moment ago";
  vehicles_[0].left_alone = 5.1;
  EXPECT_FALSE(first());
  vehicles_[1].commanded = 2.0;
  EXPECT_TRUE(first()) << "the other is held";
}

TEST_F(JunctionClearance, is_kept_by_one_of_two_inside) {
  vehicles_[0].front.y() = -3.0;
  vehicles_[0].way = {{0.0, -8.0}, {0.0, -3.0}, {0.0, 60.0}};
  vehicles_[0].junction = {.junction = 7, .begin = -2.0, .end = 7.0};
  EXPECT_TRUE(first()) << "it has farther to go";
  vehicles_[0].junction.end = 1.0;
  EXPECT_FALSE(first());
  vehicles_[0].speed = 0.0;
  EXPECT_TRUE(first()) << "it stands, so that the other does not wait for it";
}

/// The other is to come from the west, 5 m before the way of the first.
class JunctionCrossedLater : public JunctionClearance {
 protected:
  JunctionCrossedLater() {
    FleetVehicle& inside = vehicles_[1];
    inside.front.x() = -5.0;
    inside.way = {{-10.0, 0.0}, {-5.0, 0.0}, {60.0, 0.0}};
    inside.junction.end = 8.0;
  }
};

TEST_F(JunctionCrossedLater, is_kept_from_outside_however_slow_the_other_is) {
  EXPECT_TRUE(first());
  vehicles_[1].speed = 0.5;
  vehicles_[1].traits.accel = 0.01;
  EXPECT_TRUE(first()) << "it could come in and stand before the other";
  vehicles_[1].junction.end = 2.0;
  EXPECT_FALSE(first()) << "its way leaves the junction before";
}

TEST_F(JunctionCrossedLater, is_kept_by_one_that_stands_at_its_line_for_all_of_its_way) {
  vehicles_[0].speed = 0.0;
  vehicles_[0].junction = {.junction = 7, .begin = 0.0, .end = 10.0};
  const auto ahead = first();
  ASSERT_TRUE(ahead) << "it need not brake, but would stand in the other's way";
  EXPECT_NEAR(ahead->distance, 0.0, 1e-9);
}

TEST_F(JunctionCrossedLater, is_not_kept_at_the_line_by_one_that_cannot_stop_there) {
  vehicles_[0].speed = 5.0;
  const auto ahead = first();
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(ahead->distance, 6.0 - 0.9 - 0.5, 0.3) << "before the flank, and 0.5 m are left";
}

TEST_F(JunctionCrossedLater, is_kept_from_inside_for_one_that_gets_there_soon) {
  vehicles_[0].junction.begin = -2.0;
  vehicles_[0].speed = 6.0;
  EXPECT_TRUE(first()) << "it gets there within 2 s";
  vehicles_[1].speed = 0.5;
  vehicles_[1].traits.accel = 0.5;
  EXPECT_FALSE(first()) << "it takes longer";
}

TEST_F(JunctionClearance, is_kept_for_a_tail_that_swings_in) {
  // The other, a bus, turns right round the place where this one's way ends. Its front stays clear.
  FleetVehicle& bus = vehicles_[1];
  bus.traits.length = 12.0;
  bus.front = {-4.0, 3.0};
  bus.way = {{-16.0, 3.0}, {-4.0, 3.0}, {2.2, 3.0}, {2.2, -20.0}};
  bus.junction.end = 16.0;
  vehicles_[0].front = {-2.0, -3.0};
  vehicles_[0].way = {{-2.0, -8.0}, {-2.0, -3.0}, {-2.0, 0.3}};
  vehicles_[0].junction = {.junction = 7, .begin = 1.0, .end = 3.3};
  EXPECT_TRUE(first());
}

TEST_F(JunctionClearance, slows_a_vehicle_as_it_likes_to_brake) {
  const std::vector<Zone> zones(1);
  Yielding yielding(zones);
  const SafeSpeeds safe{[](const FleetVehicle&, double gap) { return gap < 5.0 ? 1.0 : 9.0; },
                        [](const FleetVehicle&, double, double) { return 9.0; }};
  vehicles_[0].commanded = -1.0;
  vehicles_[0].left_alone = 1.0;
  const auto orders = yielding.plan(vehicles_, PeopleNear({}), {}, safe, 0.0, 0.1);
  EXPECT_THAT(orders, testing::ElementsAre(SpeedOrder{"comes", 4.0 - 4.5 * 0.1}));
  EXPECT_TRUE(yielding.yielded().empty()) << "it does not give way to people";
}

}  // namespace
}  // namespace pedzone
