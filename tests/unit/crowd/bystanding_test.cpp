// People who stand where others pass: at a bus stop, chatting, waiting for somebody.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kLength = 30.0, kWidth = 2.0;  // [m] of the footway

/// 36 people as SUMO stands them at a stop of 10 m beside a footway: 12 in each of three rows, from
/// the kerb (y = 2 m) on, turned to the road.
std::vector<SeenPerson> at_a_stop() {
  std::vector<SeenPerson> people;
  for (int k = 0; k < 36; ++k) {
    SeenPerson person;
    person.position = {19.6 - 0.8 * (k % 12), kWidth - 0.67 * (k / 12)};
    person.key = 1000 + static_cast<std::uint64_t>(k);
    person.heading = 0.5 * kPi;
    people.push_back(person);
  }
  return people;
}

/// So many people on their way from each end, 4 s between them.
void add_passers(Scene& scene, int each_way) {
  for (int k = 0; k < each_way; ++k) {
    scene.add({1.0, 0.5 + 0.25 * (k % 4)}, line_at_x(kLength - 1, 0.3, 1.7));
    scene.add({kLength - 1, 0.6 + 0.25 * (k % 4)}, line_at_x(1, 0.3, 1.7));
    for (int step = 0; step < 40; ++step) scene.step();
  }
}

TEST(Bystanding, people_pass_who_wait_in_rows) {
  const Zone zone = zone_of(box(0, 0, kLength, kWidth));
  Scene scene(zone);
  scene.crowd.see(at_a_stop());
  add_passers(scene, 12);
  scene.run(180.0);
  EXPECT_EQ(scene.arrived(), scene.people.size());
}

TEST(Bystanding, steps_back_half_a_metre_at_most_and_returns) {
  const Zone zone = zone_of(box(0, 0, kLength, kWidth));
  Scene scene(zone);
  const std::vector<SeenPerson> waiting = at_a_stop();
  scene.crowd.see(waiting);
  const auto farthest = [&] {
    double most = 0.0;
    for (const SeenPerson& person : waiting) {
      const Vec2 place = scene.crowd.seen_at(person.key).value();
      EXPECT_TRUE(zone.walls.inside(place) || !zone.walls.inside(person.position));
      most = std::max(most, (place - person.position).norm());
    }
    return most;
  };
  EXPECT_EQ(farthest(), 0.0);
  double most = 0.0;
  for (int k = 0; k < 12; ++k) {
    add_passers(scene, 1);
    most = std::max(most, farthest());
  }
  EXPECT_GT(most, 0.0);
  EXPECT_LE(most, 0.5 + 1e-9);
  scene.run(180.0);
  for (int k = 0; k < 50; ++k) scene.step();
  EXPECT_LE(farthest(), 1e-6);
}

TEST(Bystanding, stays_where_there_is_room_to_pass) {
  const Zone zone = zone_of(box(0, 0, kLength, 6));
  Scene scene(zone);
  SeenPerson person;
  person.position = {15, 3};
  person.key = 7;
  scene.crowd.see(std::vector<SeenPerson>{person});
  for (int k = 0; k < 5; ++k) scene.add({2.0, 1.0 + k}, line_at_x(kLength - 1, 0.3, 5.7));
  scene.run(60.0);
  EXPECT_EQ(scene.arrived(), 5U);
  EXPECT_EQ(scene.crowd.seen_at(7).value(), person.position);
}

TEST(Bystanding, a_wheelchair_is_passed_at_its_full_width) {
  const Zone zone = zone_of(box(0, 0, kLength, 1.2));
  for (const bool turns : {true, false}) {
    Scene scene(zone);
    SeenPerson person;
    person.position = {15, 0.3};
    person.radius = 0.3;
    person.key = 7;
    person.turns = turns;
    scene.crowd.see(std::vector<SeenPerson>{person});
    for (int k = 0; k < 3; ++k) scene.add({4.0 - k, 0.4}, line_at_x(kLength - 1, 0.1, 1.1));
    double nearest = kLength;
    while (scene.arrived() < 3U && scene.time < 60.0) {
      scene.step();
      const Vec2 place = scene.crowd.seen_at(7).value();
      for (const Scene::Person& passer : scene.people) {
        nearest = std::min(nearest, (passer.view.position - place).norm());
      }
    }
    EXPECT_EQ(scene.arrived(), 3U);
    EXPECT_GE(nearest, 0.12 + (turns ? 0.15 : 0.3) - 1e-6);
  }
}

TEST(Bystanding, is_forgotten_when_sumo_puts_it_elsewhere_or_takes_it_away) {
  const Zone zone = zone_of(box(0, 0, kLength, kWidth));
  Scene scene(zone);
  std::vector<SeenPerson> people = at_a_stop();
  scene.crowd.see(people);
  add_passers(scene, 4);
  for (SeenPerson& person : people) person.position.x() -= 5.0;
  scene.crowd.see(people);
  for (const SeenPerson& person : people) {
    EXPECT_EQ(scene.crowd.seen_at(person.key).value(), person.position);
  }
  scene.crowd.see({});
  EXPECT_FALSE(scene.crowd.seen_at(people.front().key));
}

TEST(Bystanding, does_not_depend_on_the_order_in_which_people_are_seen) {
  const Zone zone = zone_of(box(0, 0, kLength, kWidth));
  Scene one(zone), other(zone);
  std::vector<SeenPerson> people = at_a_stop();
  one.crowd.see(people);
  std::ranges::reverse(people);
  other.crowd.see(people);
  add_passers(one, 6);
  add_passers(other, 6);
  for (std::size_t i = 0; i < one.people.size(); ++i) {
    EXPECT_EQ(one.people[i].view.position, other.people[i].view.position);
  }
}

/// Sits down at once and for ever, or for as long as a test takes.
NewPerson sitting_at(const Vec2& place) {
  NewPerson person;
  person.position = place;
  person.destination = line_at_x(kLength - 1, 0.1, 0.8);
  person.rates[static_cast<std::size_t>(Activity::kSitting)] = 6000.0;
  return person;
}

TEST(Bystanding, who_sits_or_chats_lets_people_pass_in_a_narrow_lane) {
  // Two bodies of 0.48 m and no more than that: a body in the middle closes the lane.
  const Zone zone = zone_of(box(0, 0, kLength, 0.97));
  Scene scene(zone);
  scene.add(sitting_at({15, 0.48}));
  for (int k = 0; k < 20; ++k) scene.step();
  for (int k = 0; k < 3; ++k) scene.add({4.0 - k, 0.48}, line_at_x(kLength - 1, 0.1, 0.8));
  scene.run(60.0);
  for (std::size_t i = 1; i < scene.people.size(); ++i) {
    EXPECT_GE(scene.people[i].arrival_time, 0.0) << i;
    EXPECT_LT(scene.people[i].arrival_time, 45.0) << i;
  }
}

}  // namespace
}  // namespace pedzone::test
