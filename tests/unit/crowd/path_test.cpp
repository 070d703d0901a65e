// The user's waypoints: all entered in turn, whatever their radius; passed over when they cannot be
// reached; no different without them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kTouch = 1e-6;

double distance_to_leg(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double squared = (b - a).squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
  return (a + t * (b - a) - p).norm();
}

/// How many of the waypoints the person came by, in turn, between its first place and its last.
std::size_t entered_in_turn(const Scene::Person& person) {
  std::size_t count = 0;
  for (std::size_t k = 1; k < person.path.size() && count < person.given.path.size(); ++k) {
    const Waypoint& waypoint = person.given.path[count];
    const double nearest = distance_to_leg(waypoint.at, person.path[k - 1], person.path[k]);
    if (nearest <= waypoint.radius + 1e-9) ++count;
  }
  return count;
}

NewPerson walker(const Vec2& from, const Destination& to, std::vector<Waypoint> path) {
  NewPerson person;
  person.position = from;
  person.destination = to;
  person.path = std::move(path);
  return person;
}

class Radius : public ::testing::TestWithParam<double> {};

TEST_P(Radius, all_are_entered_in_turn_round_corners_and_back) {
  const double radius = GetParam();
  const Zone zone = zone_of(box(0, 0, 40, 30), {box(10, 10, 30, 20)}, true);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Scene scene(zone, seed);
    // On a waypoint narrower than a body, people stand in each other's way.
    const int people = radius < 0.3 ? 1 : 4;
    for (int k = 0; k < people; ++k) {
      scene.add(walker({2.0 + k, 2.0}, line_at_x(39, 0, 30),
                       {{{5, 25}, radius},
                        {{35, 25}, radius},
                        {{20, 5}, radius},
                        {{5, 25}, radius},  // once more
                        {{35, 5}, radius}}));
    }
    scene.run(300);
    ASSERT_EQ(scene.arrived(), scene.people.size()) << "seed " << seed;
    for (const Scene::Person& person : scene.people) {
      EXPECT_EQ(entered_in_turn(person), 5u) << "seed " << seed;
      EXPECT_FALSE(person.view.gave_up);
    }
    EXPECT_GE(scene.least_wall_gap(), -kTouch);
  }
}

/// Corners of a zigzag street, each with a waypoint: nothing leads out.
TEST_P(Radius, corners_carry_nobody_out) {
  const double radius = GetParam();
  Region street = repair(box(0, 0, 20, 2));
  street = unite(street, repair(box(18, 0, 20, 20)));
  street = unite(street, repair(box(18, 18, 40, 20)));
  const Zone zone = zone_of(street, {}, true);
  for (const bool blind : {false, true}) {
    Scene scene = blind ? Scene(zone, 3, blind_model()) : Scene(zone, 3);
    const int people = blind || radius < 0.3 ? 1 : 6;
    for (int k = 0; k < people; ++k) {
      scene.add(walker({1.0 + k, 1.0}, line_at_x(39, 18, 20),
                       {{{19, 1}, radius}, {{19, 19}, radius}, {{25, 19}, radius}}));
    }
    scene.run(180);
    EXPECT_EQ(scene.arrived(), scene.people.size());
    EXPECT_GE(scene.least_wall_gap(), -kTouch);
    for (const Scene::Person& person : scene.people) EXPECT_EQ(entered_in_turn(person), 3u);
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, Radius, ::testing::Values(0.05, 0.3, 1.0, 5.0, 20.0));

TEST(Path, a_large_radius_cuts_corners_and_a_small_one_does_not) {
  const Zone zone = zone_of(box(0, 0, 40, 40));
  double walked[2];
  for (const int large : {0, 1}) {
    Scene scene(zone);
    scene.add(walker({2, 2}, line_at_x(39, 0, 4), {{{20, 30}, large ? 10.0 : 0.5}}));
    scene.run(120);
    ASSERT_EQ(scene.arrived(), 1u);
    walked[large] = scene.people[0].walked;
  }
  EXPECT_LT(walked[1], walked[0] - 10.0);
}

TEST(Path, a_waypoint_seen_through_a_wall_is_not_reached) {
  // The waypoint is 1 m away behind a wall, and 40 m on foot.
  const Zone zone = zone_of(box(0, 0, 30, 10), {box(0, 4.8, 20, 5.2)});
  Scene scene(zone);
  scene.add(walker({2, 4}, line_at_x(29, 0, 10), {{{2, 6}, 3.0}}));
  scene.run(120);
  ASSERT_EQ(scene.arrived(), 1u);
  double highest_at_left = 0.0;  // on the waypoint's side of the wall
  for (const Vec2& place : scene.people[0].path) {
    if (place.x() < 8.0) highest_at_left = std::max(highest_at_left, place.y());
  }
  EXPECT_GT(highest_at_left, 5.2);
}

TEST(Path, one_on_an_obstacle_is_passed_over_after_patience) {
  for (const double patience : {3.0, 12.0}) {
    Zone zone = zone_of(box(0, 0, 40, 20), {box(18, 8, 22, 12)});
    zone.parameters.patience = patience;
    Scene scene(zone);
    scene.add(walker({5, 10}, line_at_x(39, 0, 20), {{{20, 10}, 0.5}, {{30, 3}, 1.0}}));
    scene.run(200);
    ASSERT_EQ(scene.arrived(), 1u);
    const Scene::Person& person = scene.people[0];
    EXPECT_FALSE(person.view.gave_up);
    double nearest = 1e9;
    for (const Vec2& place : person.path) nearest = std::min(nearest, (place - Vec2(30, 3)).norm());
    EXPECT_LE(nearest, 1.0);
    // Apart from walking, which goes on a little before the obstacle, it spends its patience.
    const double spent = person.arrival_time - person.walked / 1.34;
    EXPECT_GT(spent, 0.7 * patience);
    EXPECT_LT(spent, patience + 5.0);
    EXPECT_GE(scene.least_wall_gap(), -kTouch);
  }
}

TEST(Path, an_occupied_one_is_passed_over_too) {
  const Zone zone = zone_of(box(0, 0, 40, 20), {}, true);
  Scene scene(zone);
  std::vector<SeenPerson> seen{{{20, 10}, {0, 0}, 0.24}};
  for (int k = 0; k < 12; ++k) {
    seen.push_back({Vec2(20, 10) + 0.95 * unit(k * kPi / 6), {0, 0}, 0.24});
  }
  scene.crowd.see(seen);
  scene.add(walker({5, 10}, line_at_x(39, 0, 20), {{{20, 10}, 0.3}}));
  scene.run(120);
  ASSERT_EQ(scene.arrived(), 1u);
  EXPECT_GT(scene.people[0].arrival_time, 34 / 1.34 + 8.0);
}

TEST(Path, one_without_any_way_is_passed_over_at_once) {
  const Zone zone = zone_of(unite(repair(box(0, 0, 40, 10)), repair(box(0, 20, 40, 30))));
  Scene scene(zone);
  scene.add(walker({2, 5}, line_at_x(39, 0, 10), {{{20, 25}, 1.0}, {{20, 2}, 1.0}}));
  scene.run(60);
  ASSERT_EQ(scene.arrived(), 1u);
  EXPECT_LT(scene.people[0].arrival_time, 40 / 1.34);
}

TEST(Path, the_destination_counts_only_after_the_last_waypoint) {
  // It departs on its destination, and comes back to it.
  const Zone zone = zone_of(box(0, 0, 40, 20));
  Scene scene(zone);
  scene.add(walker({5, 10}, point(5, 10), {{{25, 10}, 1.0}}));
  scene.run(60);
  ASSERT_EQ(scene.arrived(), 1u);
  EXPECT_GT(scene.people[0].walked, 2 * 18.0);
}

TEST(Path, a_new_destination_leaves_the_waypoints) {
  const Zone zone = zone_of(box(0, 0, 40, 20));
  Scene scene(zone);
  scene.add(walker({5, 10}, line_at_x(1, 0, 20), {{{20, 16}, 1.0}, {{30, 4}, 1.0}}));
  scene.run(5);
  scene.crowd.set_destination(scene.people[0].handle, line_at_x(39, 0, 20));
  scene.run(120);
  ASSERT_EQ(scene.arrived(), 1u);
  EXPECT_EQ(entered_in_turn(scene.people[0]), 2u);
  EXPECT_GT(scene.people[0].view.position.x(), 38.0);
}

TEST(Path, others_who_leave_do_not_mix_up_whose_path_it_is) {
  const Zone zone = zone_of(box(0, 0, 60, 20), {}, true);
  Scene scene(zone);
  for (int k = 0; k < 12; ++k) {
    const double x = 3.0 + 1.2 * k;
    std::vector<Waypoint> path;
    if (k % 3 != 0) path = {{{x + 5, 16}, 0.7}, {{x + 10, 4}, 0.7}};
    scene.add(walker({x, 10}, k % 3 == 0 ? point(x + 2, 10) : line_at_x(59, 0, 20), path));
  }
  scene.run(200);
  EXPECT_EQ(scene.arrived(), scene.people.size());
  for (const Scene::Person& person : scene.people) {
    EXPECT_EQ(entered_in_turn(person), person.given.path.size());
  }
}

/// Behind its last waypoint nothing is left of a path: from the same place with the same velocity a
/// person walks as one who never had any, to the bit.
TEST(Path, behind_the_last_waypoint_a_person_is_one_without_a_path) {
  const Zone zone = zone_of(box(0, 0, 60, 20));
  Scene with(zone), without(zone);
  NewPerson person = walker({2, 10}, line_at_x(59, 0, 20), {});
  without.add(person);
  person.path = {{{12, 10}, 15.0}};  // straight ahead; it is there from the first step on
  with.add(person);
  for (Scene* scene : {&with, &without}) {
    scene->crowd.see(std::vector<SeenPerson>{{{30, 10.1}, {0, 0}, 0.24}});
    scene->run(120);
  }
  ASSERT_EQ(with.arrived(), 1u);
  EXPECT_EQ(with.people[0].path, without.people[0].path);
}

TEST(Insight, tells_aim_and_rays_and_changes_nothing) {
  const Zone zone = zone_of(box(0, 0, 40, 20), {box(18, 0, 20, 12)}, true);
  const Profiles profiles;
  Scene watched(zone), alone(zone);
  for (Scene* scene : {&watched, &alone}) {
    scene->crowd.see(std::vector<SeenPerson>{{{12, 6}, {0.5, 0}, 0.24}});
    scene->vehicles = {vehicle_at({35, 15}, kPi, 2.0)};
    for (int k = 0; k < 5; ++k) {
      NewPerson person = walker({3.0 + k, 4.0 + k}, line_at_x(39, 0, 20), {{{10, 17}, 1.0}});
      if (k % 2 == 1) person.profile = profiles.find("senior");  // who is slow to notice
      scene->add(person);
    }
  }
  for (int k = 0; k < 200; ++k) {
    watched.step();
    alone.step();
    std::vector<Crowd::Handle> handles;
    for (const auto& person : watched.people) {
      if (person.here) handles.push_back(person.handle);
    }
    const auto insights = watched.crowd.insights(handles);
    ASSERT_EQ(insights.size(), handles.size());
    for (const Insight& insight : insights) {
      ASSERT_GT(insight.rays.size(), 61u);
      // No ray leads through a wall on this side of the aim: what is behind it nobody minds.
      const double to_aim = (insight.aim - insight.position).norm();
      for (const Ray& ray : insight.rays) {
        const double length = std::min(ray.free_distance, to_aim);
        const Vec2 tip = insight.position + length * unit(ray.direction);
        EXPECT_TRUE(zone.walls.free_line(insight.position, tip));
      }
      EXPECT_EQ(insight.waypoint.has_value(), insight.aim == Vec2(10, 17));
    }
  }
  for (std::size_t k = 0; k < watched.people.size(); ++k) {
    EXPECT_EQ(watched.people[k].path, alone.people[k].path);
  }
}

/// Also of somebody who has come since the last step, and when others have left since.
TEST(Insight, is_of_those_who_are_there_now) {
  const Zone zone = zone_of(box(0, 0, 200, 20));
  const Profiles profiles;
  NewPerson person = walker({10, 10}, line_at_x(199, 0, 20), {});
  person.key = 77;
  person.profile = profiles.find("senior");
  Scene fresh(zone), lived(zone);
  const auto reference = [&] {
    const auto handle = fresh.crowd.add(person);
    return fresh.crowd.insights(std::vector{handle}).at(0);
  }();
  for (int k = 0; k < 20; ++k) {  // far away; young, and not at all like the senior
    NewPerson other = walker({150.0 + k, 10}, line_at_x(199, 0, 20), {});
    other.profile = profiles.find("adult");
    lived.add(other);
  }
  for (int k = 0; k < 5; ++k) lived.step();
  for (int k = 0; k < 10; ++k) lived.crowd.remove(lived.people[k].handle);
  for (int k = 0; k < 10; ++k) lived.people[k].here = false;
  const auto late = lived.crowd.insights(std::vector{lived.crowd.add(person)}).at(0);
  ASSERT_EQ(late.rays.size(), reference.rays.size());
  for (std::size_t k = 0; k < late.rays.size(); ++k) {
    EXPECT_EQ(late.rays[k].direction, reference.rays[k].direction);
    EXPECT_EQ(late.rays[k].free_distance, reference.rays[k].free_distance);
  }
}

/// With one wall ahead, a ray is as long as geometry says: until the body's disc touches.
TEST(Insight, a_ray_ends_where_the_body_touches) {
  const Zone zone = zone_of(box(0, 0, 40, 20), {box(20, -1, 21, 21)});
  Scene scene(zone);
  NewPerson person = walker({15, 10}, point(35, 10), {});  // what is behind the goal does not count
  scene.add(person);
  const Insight insight = scene.crowd.insights(std::vector{scene.people[0].handle}).at(0);
  int checked = 0;
  for (const Ray& ray : insight.rays) {
    if (std::abs(ray.direction) > 0.5) continue;
    EXPECT_NEAR(ray.free_distance, (5.0 - person.radius) / std::cos(ray.direction), 0.01);
    ++checked;
  }
  EXPECT_GT(checked, 10);
}

}  // namespace
}  // namespace pedzone::test
