// Who is stuck among people squeezes through after a time, and is counted once; who waits for
// something else is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "group_scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kRadius = 0.24;
constexpr double kSqueezeTime = 10.0;  // [s] from the jam's begin until a body is at its narrowest
constexpr double kNarrowest = 0.25 * 0.5;  // of the full width
constexpr double kRounding = 1e-6;         // [m] radii are kept as floats

/// Runs a scene; counts by handle how often somebody began to squeeze, and when first.
struct Jams {
  std::map<Crowd::Handle, int> times;
  double first = -1.0;  ///< [s]
  int all = 0;

  void step(Scene& scene) {
    scene.step();
    for (const JamNotice& jam : scene.crowd.jams()) {
      ++times[jam.handle];
      ++all;
      if (first < 0.0) first = scene.time;
      const auto found = std::ranges::find(scene.people, jam.handle, &Scene::Person::handle);
      ASSERT_NE(found, scene.people.end());
      EXPECT_EQ(jam.position, found->view.position);
    }
  }
  void run(Scene& scene, double until) {
    while (scene.time < until && scene.arrived() < scene.people.size()) step(scene);
  }
};

// Centres can be 0.65 - 2 * 0.24 = 0.17 m aside there: less than two turned radii, 0.24 m.
constexpr double kFootway = 0.65;

Zone footway(double jam_time, bool noise = true) {
  Zone zone = zone_of(box(0, 0, 20, kFootway), {}, noise);
  zone.parameters.jam_time = jam_time;
  return zone;
}

Zone open_place(double jam_time) {
  Zone zone = zone_of(box(0, 0, 40, 20), {}, true);
  zone.parameters.jam_time = jam_time;
  return zone;
}

TEST(Jam, two_who_meet_on_a_footway_too_narrow_get_past_each_other_after_the_jam_time) {
  for (const double jam_time : {5.0, 20.0}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Zone zone = footway(jam_time);
      Scene scene(zone, seed);
      scene.add({2, 0.325}, line_at_x(19.5, 0, kFootway));
      scene.add({18, 0.325}, line_at_x(0.5, 0, kFootway));
      Jams jams;
      const double meet = 8.0 / 1.34;
      while (scene.time < meet + jam_time - 1.0) {
        jams.step(scene);
        ASSERT_LT(scene.people[0].view.position.x(), scene.people[1].view.position.x());
      }
      jams.run(scene, meet + jam_time + kSqueezeTime + 8.0 / 1.34 + 10.0);
      EXPECT_EQ(scene.arrived(), 2u) << "seed " << seed;
      EXPECT_EQ(jams.all, 2) << "seed " << seed;
      for (const auto& p : scene.people) EXPECT_EQ(jams.times[p.handle], 1) << "seed " << seed;
      EXPECT_GT(jams.first, meet + jam_time - 2.0);
      EXPECT_LT(jams.first, meet + jam_time + 3.0);
      // As if one stepped off the kerb: a body at its narrowest stays inside, so its centre does.
      EXPECT_GE(scene.least_wall_gap(), kNarrowest * kRadius - kRadius - kRounding);
      for (const auto& p : scene.people) EXPECT_FALSE(p.view.gave_up);
    }
  }
}

TEST(Jam, leaves_nobody_narrow_behind_it) {
  // Also who cannot turn, but squeezes all the same.
  for (const char* id : {"adult", "wheelchair"}) {
    const Region space = unite(repair(box(0, 0, 20, kFootway)), repair(box(20, -5, 60, 5)));
    Zone zone = zone_of(space, {}, true);
    zone.parameters.jam_time = 5.0;
    Scene scene(zone);
    NewPerson person = member({2, 0.325}, line_at_x(59, -5, 5), 0);
    person.profile = profile(id);
    scene.add(person);
    scene.add({18, 0.325}, line_at_x(0.5, 0, kFootway));
    Jams jams;
    double narrowest = 1e9, narrow_beyond = 1e9;
    while (scene.people[0].here && scene.time < 120.0) {
      jams.step(scene);
      const auto& view = scene.people[0].view;
      narrowest = std::min(narrowest, view.radius);
      if (view.position.x() > 30.0) narrow_beyond = std::min(narrow_beyond, view.radius);
    }
    EXPECT_FALSE(scene.people[0].here) << id;
    EXPECT_LT(narrowest, 0.8 * kRadius) << id;
    EXPECT_NEAR(narrow_beyond, kRadius, kRounding) << id;
    EXPECT_EQ(jams.all, 2) << id;
  }
}

TEST(Jam, is_none_where_people_get_on) {
  // A slow queue in a passage: everybody lacks room and turns, but comes nearer.
  Zone zone = zone_of(box(0, 0, 60, kFootway), {}, true);
  zone.parameters.jam_time = 5.0;
  Scene scene(zone);
  for (int k = 0; k < 6; ++k) {
    scene.add({8.0 - 0.7 * k, 0.325}, line_at_x(59, 0, kFootway), k == 0 ? 0.3 : 1.34);
  }
  Jams jams;
  jams.run(scene, 60.0);
  EXPECT_EQ(jams.all, 0);
  EXPECT_LT(scene.people[5].view.position.x(), 0.3 * 60.0 + 8.0);  // they did queue
}

TEST(Jam, is_none_at_a_dead_end) {
  // The way is closed by a wall; there is no other, and the goal is far behind it. Nobody is near.
  Zone zone = zone_of(box(0, 0, 40, 12), {box(20, -1, 20.5, 13)}, true);
  zone.parameters.jam_time = 5.0;
  Scene scene(zone);
  for (const double y : {2.0, 10.0}) scene.add({10, y}, line_at_x(39, 0, 12));
  Jams jams;
  jams.run(scene, 60.0);
  EXPECT_EQ(scene.arrived(), 0u);
  for (const auto& p : scene.people) EXPECT_GT(p.view.position.x(), 19.0);
  EXPECT_EQ(jams.all, 0);
}

TEST(Jam, counts_nobody_again_until_the_jam_time_has_passed_once_more) {
  // Several who press at a dead end are stuck among people: for ever.
  Zone zone = zone_of(box(0, 0, 40, 4), {box(20, -1, 20.5, 5)}, true);
  zone.parameters.jam_time = 5.0;
  Scene scene(zone);
  for (int k = 0; k < 4; ++k) scene.add({10, 0.5 + k}, line_at_x(39, 0, 4));
  Jams jams;
  constexpr double kUntil = 60.0;
  jams.run(scene, kUntil);
  for (const auto& p : scene.people) EXPECT_LE(jams.times[p.handle], kUntil / 5.0);
}

TEST(Jam, is_none_for_who_waits_for_vehicles) {
  // A column that outlasts the jam time crosses before a queue of five.
  Zone zone = open_place(5.0);
  zone.walkable = subtract(repair(box(0, 0, 40, 20)), repair(box(-1, -1, 18, 9)));
  zone.walkable = subtract(zone.walkable, repair(box(-1, 10.2, 18, 21)));
  zone.walls = WallIndex(zone.walkable);
  zone.ways = WayFinder(zone.walkable, 0.5);
  Scene scene(zone);
  for (int k = 0; k < 5; ++k) scene.add({14.0 - 0.8 * k, 9.6}, line_at_x(39, 0, 20));
  for (int k = 0; k < 30; ++k) {
    scene.vehicles.push_back(vehicle_at({22, -10.0 - 7.0 * k}, kPi / 2, 3.0));
  }
  Jams jams;
  jams.run(scene, 40.0);
  EXPECT_EQ(scene.arrived(), 0u);
  for (const auto& p : scene.people) EXPECT_LT(p.view.position.x(), 22.0);
  EXPECT_EQ(jams.all, 0);
}

TEST(Jam, is_none_for_who_waits_for_its_group) {
  Zone zone = footway(3.0);
  Scene scene(zone);
  scene.add(member({10, 0.325}, line_at_x(19.5, 0, kFootway), 1));
  NewPerson last = member({2, 0.325}, line_at_x(19.5, 0, kFootway), 1);
  last.preferred_speed = 0.4;
  last.velocity *= 0.3;
  scene.add(last);
  // Somebody stands before it, so that it lacks room as well.
  const std::vector<SeenPerson> seen{{{13.6, 0.325}, {0, 0}, 0.24}};
  Jams jams;
  double waited = 0.0;
  while (scene.time < 14.0) {
    scene.crowd.see(seen);
    jams.step(scene);
    waited += scene.people[0].view.waits_for_group ? 0.1 : 0.0;
  }
  EXPECT_GT(waited, 2.0 * 3.0);
  EXPECT_EQ(jams.all, 0);
}

TEST(Jam, begins_anew_with_a_new_destination) {
  const Zone zone = footway(5.0, false);
  Scene scene(zone);
  scene.add({9.5, 0.325}, line_at_x(19.5, 0, kFootway));
  scene.add({10.5, 0.325}, line_at_x(0.5, 0, kFootway));
  Jams jams;
  for (int k = 0; k < 8; ++k) {
    for (int step = 0; step < 40; ++step) jams.step(scene);  // 4 s
    for (const auto& p : scene.people) {
      scene.crowd.set_destination(p.handle, p.given.destination);
    }
  }
  EXPECT_EQ(jams.all, 0);
  for (int step = 0; step < 70; ++step) jams.step(scene);
  EXPECT_EQ(jams.all, 2);
}

}  // namespace
}  // namespace pedzone::test
