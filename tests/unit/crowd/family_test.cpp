// Families: an adult keeps its child close, and takes its hand when a vehicle is near.
#include <gtest/gtest.h>

#include <cmath>

#include "group_scene.hpp"

namespace pedzone::test {
namespace {

/// An adult and a child who go 90 m along +x.
class Family {
 public:
  explicit Family(const char* its_profile = "infant", const Vec2& child_at = {5, 11},
                  const Vec2& adult_at = {5, 10})
      : zone(zone_of(box(0, 0, 101, 20), {}, true)), scene(zone) {
    adult = scene.add(member(adult_at, line_at_x(100, 1, 19), 3));
    NewPerson small = member(child_at, line_at_x(100, 1, 19), 3);
    small.profile = profile(its_profile);
    small.radius = 0.15;
    small.preferred_speed = 0.8;
    small.velocity *= 0.8 / 1.34;
    child = scene.add(small);
  }

  const PersonView& of(std::size_t person) const { return scene.people[person].view; }
  double apart() const { return (of(adult).position - of(child).position).norm(); }
  bool together() const { return scene.people[adult].here && scene.people[child].here; }

  Zone zone;
  Scene scene;
  std::size_t adult, child;
};

TEST(Family, an_adult_goes_no_faster_than_its_child_who_stays_close) {
  for (const char* name : {"infant", "child"}) {
    Family family(name);
    double widest = 0.0;
    while (family.together() && family.scene.time < 300) {
      family.scene.step();
      if (!family.together()) break;
      widest = std::max(widest, family.apart());
      EXPECT_TRUE(family.scene.time < 5 || family.of(family.adult).velocity.norm() <= 0.85);
      EXPECT_FALSE(family.of(family.child).holds_hand);
      EXPECT_FALSE(family.of(family.child).waits_for_group);
    }
    EXPECT_LE(widest, 2.5) << name;
    family.scene.run(400);
    EXPECT_EQ(family.scene.arrived(), 2u) << name;
  }
}

TEST(Family, a_child_that_is_far_away_comes_to_its_adult) {
  Family family("child", {12, 16}, {5, 6});
  while (family.scene.time < 14) family.scene.step();
  EXPECT_LE(family.apart(), 2.5);
}

TEST(Family, a_child_with_another_way_than_its_adult_takes_it) {
  const Zone zone = zone_of(box(0, 0, 101, 20), {}, true);
  Scene scene(zone);
  scene.add(member({50, 10}, line_at_x(100, 1, 19), 3));
  NewPerson child = member({50, 12}, line_at_x(1, 1, 19), 3);
  child.profile = profile("child");
  scene.add(child);
  scene.run(60);
  EXPECT_EQ(scene.arrived(), 2u);
  EXPECT_LT(scene.time, 50.0);
}

TEST(Family, the_hand_is_taken_before_a_vehicle_comes_and_let_go_after) {
  for (const double lane : {8.0, 10.0, 14.0}) {
    Family family;
    family.scene.vehicles = {vehicle_at({60, lane}, kPi, 3.0)};
    bool held = false, in_time = false;
    double last_near = 0.0, loose_at = -1.0;
    while (family.together() && family.scene.time < 40) {
      family.scene.step();
      const VehicleState& vehicle = family.scene.vehicles[0];
      const double near = clearance(vehicle, family.of(family.child).position);
      const bool holds = family.of(family.child).holds_hand;
      if (near < 10.0) last_near = family.scene.time;
      if (holds && near > 7.0 && vehicle.centre.x() > family.of(family.child).position.x()) {
        in_time = true;
      }
      if (held && !holds) loose_at = family.scene.time;
      EXPECT_TRUE(!held || !holds || family.apart() <= 0.24 + 0.15 + 1.5 + 0.1);
      held = holds;
    }
    EXPECT_TRUE(in_time) << lane;
    EXPECT_FALSE(held) << lane;
    EXPECT_NEAR(loose_at, last_near + 2.0, 0.4) << lane;
    EXPECT_GE(family.scene.least_vehicle_gap(), 0.0) << lane;
    family.scene.run(400);
    EXPECT_EQ(family.scene.arrived(), 2u) << lane;
  }
}

TEST(Family, hand_in_hand_the_adult_is_between_child_and_vehicle) {
  for (const double lane : {6.0, 14.0}) {
    // The child starts on the vehicle's side.
    Family family("infant", {5, lane < 10 ? 9.2 : 10.8});
    family.scene.vehicles = {vehicle_at({45, lane}, kPi, 3.0)};
    int beside = 0, guarded = 0;
    while (family.scene.time < 20) {
      family.scene.step();
      const VehicleState& vehicle = family.scene.vehicles[0];
      const Vec2 child = family.of(family.child).position, adult = family.of(family.adult).position;
      if (std::abs(vehicle.centre.x() - child.x()) > 3.0) continue;
      ++beside;
      guarded += clearance(vehicle, adult) < clearance(vehicle, child) ? 1 : 0;
      EXPECT_TRUE(family.of(family.child).holds_hand);
    }
    EXPECT_GT(beside, 5);
    EXPECT_EQ(guarded, beside) << lane;
  }
}

TEST(Family, a_parked_vehicle_is_no_reason_for_a_hand) {
  Family family;
  family.scene.vehicles = {vehicle_at({30, 6}, 0.0, 0.0)};
  while (family.together() && family.scene.time < 200) {
    family.scene.step();
    ASSERT_FALSE(family.of(family.child).holds_hand);
  }
}

TEST(Family, a_child_whose_adult_has_gone_walks_on_alone) {
  Family family;
  family.scene.vehicles = {vehicle_at({14, 10}, kPi, 0.5)};
  while (!family.of(family.child).holds_hand && family.scene.time < 20) family.scene.step();
  ASSERT_TRUE(family.of(family.child).holds_hand);
  family.scene.crowd.remove(family.scene.people[family.adult].handle);
  family.scene.people[family.adult].here = false;
  family.scene.step();
  EXPECT_FALSE(family.of(family.child).holds_hand);
  family.scene.run(300);
  EXPECT_FALSE(family.scene.people[family.child].here);
}

TEST(Family, children_without_an_adult_are_an_ordinary_group) {
  const Zone zone = zone_of(box(0, 0, 101, 20), {}, true);
  Scene scene(zone);
  NewPerson ahead = member({20, 10}, line_at_x(100, 1, 19), 1);
  NewPerson behind = member({10, 10}, line_at_x(100, 1, 19), 1);
  ahead.profile = behind.profile = profile("child");
  const auto first = scene.add(ahead);
  scene.add(behind);
  scene.step();
  EXPECT_TRUE(scene.people[first].view.waits_for_group);
  scene.run(200);
  EXPECT_EQ(scene.arrived(), 2u);
}

}  // namespace
}  // namespace pedzone::test
