// Who is stuck among people squeezes through after a time, and is counted once; who waits for
// something else is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "group_scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kFaceToFace = 12.0;   // so many times as fast does time pass for two who face
constexpr double kSqueezeTime = 10.0;  // [s] from the jam's begin until a body is at its narrowest
constexpr double kRounding = 1e-6;     // [m] radii are kept as floats

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

// One stripe of SUMO's. Bodies of 0.7 m that have turned need as much for two of them.
constexpr double kFootway = 0.65, kRadius = 0.35;

Zone footway(double jam_time, bool noise = true, double length = 20.0) {
  Zone zone = zone_of(box(0, 0, length, kFootway), {}, noise);
  zone.parameters.jam_time = jam_time;
  return zone;
}

/// Somebody on the footway who walks to that x.
NewPerson on_footway(double x, double to, std::uint64_t group = 0) {
  NewPerson person = member({x, 0.5 * kFootway}, line_at_x(to, 0, kFootway), group);
  person.radius = kRadius;
  return person;
}

TEST(Jam, two_who_meet_on_a_footway_too_narrow_get_past_each_other_after_a_part_of_the_jam_time) {
  for (const double jam_time : {5.0, 20.0}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Zone zone = footway(kFaceToFace * jam_time);
      Scene scene(zone, seed);
      scene.add(on_footway(2, 19.5));
      scene.add(on_footway(18, 0.5));
      Jams jams;
      const double meet = 8.0 / 1.34;
      while (scene.time < meet + jam_time - 1.0) {
        jams.step(scene);
        ASSERT_LT(scene.people[0].view.position.x(), scene.people[1].view.position.x());
      }
      jams.run(scene, meet + jam_time + kSqueezeTime + 8.0 / 1.34 + 10.0);
      EXPECT_EQ(scene.arrived(), 2u) << "seed " << seed;
      // Where one of them has squeezed past, the other need not.
      EXPECT_GE(jams.all, 1) << "seed " << seed;
      for (const auto& p : scene.people) EXPECT_LE(jams.times[p.handle], 1) << "seed " << seed;
      EXPECT_GT(jams.first, meet + jam_time - 2.0);
      EXPECT_LT(jams.first, meet + 1.3 * jam_time + 3.0);
      // In the middle a straight body lacks 0.025 m; beside, what it has grown by in a step.
      EXPECT_GE(scene.least_wall_gap(), 0.5 * kFootway - kRadius - 0.1 * 0.5 * kRadius);
      for (const auto& p : scene.people) EXPECT_FALSE(p.view.gave_up);
    }
  }
}

/// [s] for which somebody and those it meets, first in the middle of a footway, then at its end,
/// stand before each other until one of them begins to squeeze.
std::vector<double> patience_on_footway(double length) {
  const Zone zone = footway(60.0, true, length);
  Scene scene(zone);
  const auto first = scene.add(on_footway(2, length - 0.5));
  const auto second = scene.add(on_footway(8, 0.5));
  NewPerson slow = on_footway(length - 1.5, 0.5);
  slow.preferred_speed = 0.1;
  slow.velocity = {-0.1, 0.0};
  const auto third = scene.add(slow);
  std::vector<double> met, squeezed;  // [s]
  while (scene.time < 120.0 && squeezed.size() < 2) {
    scene.step();
    // Where one of two begins, the other need not.
    if (!scene.crowd.jams().empty() && squeezed.size() < met.size()) squeezed.push_back(scene.time);
    const auto& other = scene.people[met.empty() ? second : third];
    if (met.size() == 2 || !other.here) continue;
    const Vec2 apart = scene.people[first].view.position - other.view.position;
    if (apart.norm() < kRadius + 0.15) met.push_back(scene.time);
  }
  if (met.size() != 2 || squeezed.size() != 2) return {0.0, 0.0};
  return {squeezed[0] - met[0], squeezed[1] - met[1]};
}

TEST(Jam, is_left_sooner_by_who_has_squeezed_a_short_way_ago) {
  const std::vector<double> soon = patience_on_footway(20.0), later = patience_on_footway(60.0);
  EXPECT_GT(soon[0], 4.5);
  EXPECT_GT(soon[1], 0.0);
  EXPECT_LT(soon[1], 3.0);
  EXPECT_GT(later[0], 4.5);
  EXPECT_GT(later[1], 4.5);
}

TEST(Jam, leaves_nobody_narrow_behind_it) {
  // Also who cannot turn, but squeezes all the same.
  for (const char* id : {"adult", "wheelchair"}) {
    const Region space = unite(repair(box(0, 0, 20, kFootway)), repair(box(20, -5, 60, 5)));
    Zone zone = zone_of(space, {}, true);
    zone.parameters.jam_time = 5.0;
    Scene scene(zone);
    NewPerson person = on_footway(2, 0);
    person.destination = line_at_x(59, -5, 5);
    person.heading = 0.0;
    person.velocity = {1.34, 0.0};
    person.profile = profile(id);
    scene.add(person);
    scene.add(on_footway(18, 0.5));
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
    NewPerson person = on_footway(8.0 - 0.9 * k, 59);
    if (k == 0) person.preferred_speed = 0.3;
    person.velocity = {person.preferred_speed, 0.0};
    scene.add(person);
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
  // A queue in a lane, and at its end a column that outlasts the jam time.
  const Region space = unite(repair(box(0, 0, 20, kFootway)), repair(box(20, -10, 40, 10)));
  Zone zone = zone_of(space, {}, true);
  zone.parameters.jam_time = 5.0;
  Scene scene(zone);
  for (int k = 0; k < 5; ++k) {
    NewPerson person = on_footway(17.0 - 0.9 * k, 0);
    person.destination = line_at_x(39, -10, 10);
    person.heading = 0.0;
    person.velocity = {1.34, 0.0};
    scene.add(person);
  }
  for (int k = 0; k < 30; ++k) {
    scene.vehicles.push_back(vehicle_at({21.4, -10.0 - 7.0 * k}, kPi / 2, 3.0));
  }
  Jams jams;
  int turned = 0;
  while (scene.time < 40.0) {
    jams.step(scene);
    turned += scene.people[2].view.radius < 0.9 * kRadius ? 1 : 0;
  }
  EXPECT_EQ(scene.arrived(), 0u);
  for (const auto& p : scene.people) EXPECT_LT(p.view.position.x(), 22.0);
  EXPECT_GT(turned, 200);  // of 400 steps: for want of room in the queue
  EXPECT_EQ(jams.all, 0);
}

/// Stands, turned, and says whether it waits.
std::unique_ptr<WalkingModel> turned_model(bool waits) {
  return fixed_model({.waits = waits, .turns = true});
}

TEST(Jam, is_none_for_who_says_that_it_waits) {
  const Zone zone = footway(5.0);
  for (const bool waits : {true, false}) {
    Scene scene(zone, 1, turned_model(waits));
    scene.add(on_footway(5, 19.5));
    Jams jams;
    jams.run(scene, 20.0);
    EXPECT_EQ(jams.all, waits ? 0 : 1);
  }
}

TEST(Jam, lasts_the_whole_jam_time_for_two_who_have_passed_each_other) {
  // Back to back: neither is in the other's way.
  const Zone zone = footway(24.0);
  for (const bool passed : {true, false}) {
    Scene scene(zone, 1, turned_model(false));
    for (const bool there : {true, false}) {
      NewPerson person = on_footway(there == passed ? 10.4 : 10.0, there ? 19.5 : 0.5);
      person.velocity = Vec2::Zero();
      scene.add(person);
    }
    Jams jams;
    jams.run(scene, 20.0);
    EXPECT_EQ(jams.all, passed ? 0 : 2);
  }
}

TEST(Jam, is_none_for_who_waits_for_its_group) {
  // The other one is 8 m behind. It does not come, but the patience for that is not over yet.
  const Zone zone = footway(5.0);
  Scene scene(zone, 1, turned_model(false));
  const auto first = scene.add(on_footway(10, 19.5, 1)), last = scene.add(on_footway(2, 19.5, 1));
  Jams jams;
  double waited = 0.0;
  while (scene.time < 9.0) {
    jams.step(scene);
    waited += scene.people[first].view.waits_for_group ? 0.1 : 0.0;
  }
  EXPECT_GT(waited, 8.0);
  EXPECT_EQ(jams.times[scene.people[first].handle], 0);
  EXPECT_EQ(jams.times[scene.people[last].handle], 1);
}

TEST(Jam, begins_anew_with_a_new_destination) {
  const Zone zone = footway(60.0, false);  // 5 s face to face
  Scene scene(zone);
  scene.add(on_footway(9.3, 19.5));
  scene.add(on_footway(10.7, 0.5));
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
