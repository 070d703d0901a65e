// Waypoints: corners, lost sight, patience.
#include <gtest/gtest.h>

#include <cmath>

#include "crowd/state/route.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kTouch = 1e-6;

/// Stands for ever whatever it wants; everybody else walks straight on.
class StandingModel : public WalkingModel {
 public:
  explicit StandingModel(double standing_speed) : limit_(standing_speed) {}
  void prepare(const Snapshot& snapshot) override { persons_ = snapshot.persons; }
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override {
    for (std::size_t i = first; i < last; ++i) {
      const double speed = persons_->preferred_speed[i];
      decisions[i] = {persons_->goal_direction[i], speed < limit_ ? 0.0 : speed, 10.0, waits_};
    }
  }
  bool waits_ = false;

 private:
  double limit_;
  const Persons* persons_ = nullptr;
};

class Corner : public ::testing::TestWithParam<double> {};

TEST_P(Corner, carries_nobody_out_whatever_the_radius) {
  Zone zone = zone_of(unite(repair(box(0, 0, 20, 2)), repair(box(18, 0, 20, 20))), {}, true);
  zone.parameters.waypoint_radius = GetParam();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Scene scene(zone, seed);
    for (int k = 0; k < 6; ++k) scene.add({1.0 + k, 0.5 + 0.2 * k}, line_at_y(19, 18, 20));
    scene.run(90);
    EXPECT_EQ(scene.arrived(), scene.people.size()) << "seed " << seed;
    EXPECT_GE(scene.least_wall_gap(), -kTouch);
  }
}

// And the same for bodies that look at nothing.
TEST_P(Corner, holds_the_blind_inside_too) {
  Zone zone = zone_of(unite(repair(box(0, 0, 20, 2)), repair(box(18, 0, 20, 20))));
  zone.parameters.waypoint_radius = GetParam();
  Scene scene(zone, 1, blind_model());
  scene.add({1, 1}, line_at_y(19, 18, 20), 3.0);
  scene.run(60);
  EXPECT_EQ(scene.arrived(), 1u);
  EXPECT_GE(scene.least_wall_gap(), -kTouch);
}

INSTANTIATE_TEST_SUITE_P(Radii, Corner, ::testing::Values(0.1, 1.0, 5.0, 20.0));

TEST(Waypoints, an_obtuse_corner_is_cut_as_soon_as_the_next_leg_is_in_view) {
  // From the lower left round the house's corner at (20, 10) to the right.
  const Zone zone = zone_of(box(0, 0, 40, 30), {box(0, 10, 20, 20)});
  Scene scene(zone);
  const auto person = scene.add({2, 8}, point(38, 28));
  scene.run(60);
  ASSERT_EQ(scene.arrived(), 1u);
  EXPECT_LT(scene.people[person].walked, 1.01 * zone.ways.distance({2, 8}, {38, 28}));
}

TEST(Waypoints, who_is_pushed_out_of_sight_of_its_waypoint_finds_its_way_again) {
  // A vehicle pushes the person back into the side street it came from.
  const Zone zone = zone_of(unite(repair(box(0, 0, 40, 6)), repair(box(10, -20, 13, 6))));
  Scene scene(zone, 1, blind_model());
  const auto person = scene.add({11.5, -2}, line_at_x(39, 0, 6), 1.34, 0.0);
  for (int k = 0; k < 30; ++k) scene.step();  // it now walks along the street
  ASSERT_GT(scene.people[person].view.position.y(), 0.0);
  scene.vehicles = {
      vehicle_at({scene.people[person].view.position.x(), 4.5}, -kPi / 2, 3.0, 3, 30)};
  for (int k = 0; k < 20; ++k) scene.step();
  scene.vehicles.clear();
  scene.run(90);
  EXPECT_EQ(scene.arrived(), 1u);
  EXPECT_FALSE(scene.people[person].view.gave_up);
  EXPECT_GE(scene.least_wall_gap(), -kTouch);
}

TEST(Patience, an_occupied_destination_ends_the_walk_beside_it) {
  // A tight ring of people who stand round the point: closer together than bodies as wide as they
  // can be at the narrowest.
  for (const double turned_width : {1.0, 0.5}) {
    Zone zone = zone_of(box(0, 0, 40, 20), {}, true);
    zone.parameters.turned_width = turned_width;
    Scene scene(zone);
    std::vector<SeenPerson> seen;
    const int ring = turned_width < 1.0 ? 24 : 12;  // 0.25 and 0.49 m apart
    for (int k = 0; k < ring; ++k)
      seen.push_back({Vec2(30, 10) + 0.95 * unit(2 * k * kPi / ring), {0, 0}, 0.24});
    seen.push_back({{30, 10}, {0, 0}, 0.24});
    scene.crowd.see(seen);
    const auto person = scene.add({5, 10}, point(30, 10));
    scene.run(25 / 1.34 + 10 + 5);
    ASSERT_EQ(scene.arrived(), 1u);
    const auto& p = scene.people[person];
    EXPECT_TRUE(p.view.gave_up);
    EXPECT_LE((p.view.position - Vec2(30, 10)).norm(), 3.0);
    EXPECT_GT(p.arrival_time, 23 / 1.34 + 10 - 1);
  }
}

TEST(Patience, nobody_gives_up_far_from_the_destination) {
  const Zone zone = zone_of(box(0, 0, 40, 4), {box(20, 0.02, 20.5, 3.98)});
  Scene scene(zone, 1);
  const auto person = scene.add({5, 2}, line_at_x(39, 0, 4));
  scene.run(60);
  EXPECT_EQ(scene.arrived(), 0u);
  EXPECT_FALSE(scene.people[person].view.gave_up);
  EXPECT_LT(scene.people[person].view.position.x(), 20.0);
}

TEST(Patience, is_not_spent_on_waiting_for_vehicles) {
  const Zone zone = zone_of(box(0, 0, 40, 20));
  for (const bool waits : {false, true}) {
    auto model = std::make_unique<StandingModel>(10.0);
    model->waits_ = waits;
    Scene scene(zone, 1, std::move(model));
    const auto person = scene.add({28, 10}, point(30, 10), 1.34, 0.0);
    scene.run(30);
    EXPECT_EQ(scene.arrived(), waits ? 0u : 1u);
    EXPECT_EQ(scene.people[person].view.gave_up, !waits);
    EXPECT_EQ(scene.people[person].view.motion, waits ? Motion::kWaiting : Motion::kStanding);
  }
}

TEST(Patience, is_the_parameter) {
  for (const double patience : {2.0, 20.0}) {
    Zone zone = zone_of(box(0, 0, 40, 20));
    zone.parameters.patience = patience;
    Scene scene(zone, 1, std::make_unique<StandingModel>(10.0));
    scene.add({28, 10}, point(30, 10), 1.34, 0.0);
    scene.run(60);
    EXPECT_NEAR(scene.people[0].arrival_time, patience, 0.25);
  }
}

TEST(Waypoints, a_blocked_waypoint_is_left_for_the_next) {
  // The corner waypoint is occupied by somebody who stands there; the next one can be reached
  // past it.
  const Zone zone = zone_of(box(0, 0, 40, 30), {box(0, 10, 20, 20)}, true);
  Scene scene(zone);
  scene.crowd.see(
      std::vector<SeenPerson>{{{20.3, 9.7}, {0, 0}, 0.24}, {{19.7, 9.4}, {0, 0}, 0.24}});
  scene.add({2, 8}, point(5, 28));
  scene.run(90);
  EXPECT_EQ(scene.arrived(), 1u);
  EXPECT_FALSE(scene.people[0].view.gave_up);
}

TEST(Route, aims_are_shortened_by_the_body_and_moved_inside) {
  const Zone zone = zone_of(box(0, 0, 40, 20));
  Route route;
  plan(zone, {20, 10}, 0.25, line_at_x(40, 4, 16), route);
  EXPECT_NEAR(route.aim_a.x(), 39.75, 1e-6);
  EXPECT_NEAR(route.aim_a.y(), 4.25, 1e-6);
  EXPECT_NEAR(route.aim_b.y(), 15.75, 1e-6);
  EXPECT_TRUE(route.last_in_view);
  plan(zone, {20, 10}, 0.25, line_at_x(30, 9.9, 10.1), route);  // shorter than the body
  EXPECT_NEAR((route.aim_a - route.aim_b).norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace pedzone::test
