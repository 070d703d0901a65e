// Bodies are narrower while their owners turn their shoulders, and as wide as ever afterwards,
// without anybody being pushed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "group_scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kRadius = 0.24, kTurned = 0.5 * kRadius;
// [m] Contacts are taken apart in four passes, which leave a little where walls push back: the
// limit of all tests of overlap.
constexpr double kOverlap = 0.01;
constexpr double kRounding = 1e-6;  // [m] radii are kept as floats
// [s] Who is put into a crowd is narrow, and straightens within the time to turn, 1 s.
constexpr double kSettled = 1.2;

// ---- passing ------------------------------------------------------------------------------------

struct Meeting {
  double nearest = 1e9, narrowest = 1e9;  ///< [m] between centres, radius
  std::size_t arrived = 0;
  double time = 0.0;  ///< [s]
  bool jammed = false;
};

Meeting meet_in_corridor(const Zone& zone, double width, std::uint64_t seed) {
  Scene scene(zone, seed);
  scene.add({2, 0.5 * width}, line_at_x(19, 0, width));
  scene.add({18, 0.5 * width}, line_at_x(1, 0, width));
  Meeting meeting;
  while (scene.time < 40.0 && scene.arrived() < 2) {
    scene.step();
    meeting.jammed = meeting.jammed || !scene.crowd.jams().empty();
    for (const auto& p : scene.people) {
      if (scene.time > kSettled) meeting.narrowest = std::min(meeting.narrowest, p.view.radius);
    }
    if (scene.arrived() > 0) continue;
    const Vec2 apart = scene.people[0].view.position - scene.people[1].view.position;
    meeting.nearest = std::min(meeting.nearest, apart.norm());
  }
  meeting.arrived = scene.arrived();
  meeting.time = scene.time;
  return meeting;
}

TEST(Shoulders, of_two_who_meet_in_a_narrow_corridor_turn_and_they_pass) {
  // Centres can be 0.9 - 2 * 0.24 = 0.42 m apart there: less than 2 * 0.24, more than 2 * 0.12.
  const Zone zone = zone_of(box(0, 0, 20, 0.9), {}, true);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Meeting meeting = meet_in_corridor(zone, 0.9, seed);
    EXPECT_EQ(meeting.arrived, 2u) << seed;
    EXPECT_LT(meeting.time, 17 / 1.34 + 5.0) << seed;
    EXPECT_GE(meeting.nearest, 2 * kTurned - kOverlap) << seed;
    EXPECT_LT(meeting.nearest, 2 * kRadius) << seed;
    EXPECT_NEAR(meeting.narrowest, kTurned, kRounding) << seed;
    EXPECT_FALSE(meeting.jammed) << seed;
  }
}

TEST(Shoulders, that_do_not_turn_do_not_pass_there) {
  Zone zone = with_hard_bodies(zone_of(box(0, 0, 20, 0.9), {}, true));
  zone.parameters.jam_time = 3600.0;  // nobody squeezes
  const Meeting meeting = meet_in_corridor(zone, 0.9, 1);
  EXPECT_EQ(meeting.arrived, 0u);
  EXPECT_GE(meeting.nearest, 2 * kRadius - 0.05);  // they press
  EXPECT_NEAR(meeting.narrowest, kRadius, kRounding);
}

TEST(Shoulders, stay_straight_where_there_is_room) {
  const Zone zone = zone_of(box(0, 0, 20, 6), {}, true);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Meeting meeting = meet_in_corridor(zone, 6, seed);
    EXPECT_EQ(meeting.arrived, 2u);
    EXPECT_GE(meeting.nearest, 2 * kRadius - kOverlap);
    EXPECT_NEAR(meeting.narrowest, kRadius, kRounding);
  }
}

TEST(Shoulders, of_who_walks_behind_somebody_keep_the_full_distance_though_turned) {
  // No room to overtake: centres are at most 0.65 - 2 * 0.24 = 0.17 m aside.
  const Zone zone = zone_of(box(0, 0, 40, 0.65), {}, true);
  Scene scene(zone);
  const auto slow = scene.add({4, 0.325}, line_at_x(39, 0, 0.65), 0.5);
  const auto fast = scene.add({1, 0.325}, line_at_x(39, 0, 0.65), 1.5);
  double nearest = 1e9;
  int turned = 0;
  while (scene.time < 50.0) {
    scene.step();
    const auto &ahead = scene.people[slow].view, &behind = scene.people[fast].view;
    nearest = std::min(nearest, (ahead.position - behind.position).norm());
    turned += behind.radius < kRadius - kOverlap ? 1 : 0;
  }
  EXPECT_GT(turned, 100);  // of 500 steps
  EXPECT_GE(nearest, 2 * kRadius - kOverlap);
}

// ---- who stands ---------------------------------------------------------------------------------

constexpr double kTurnReach = 1.5;  // [m] for somebody so near, shoulders are turned

TEST(Shoulders, of_who_stands_turn_for_who_passes_and_straighten_after) {
  struct Case {
    double aside;  ///< [m]
    bool near;
  };
  for (const Case c : {Case{0.4, true}, Case{1.8, false}}) {
    const Zone zone = zone_of(box(0, 0, 40, 20));
    Crowd crowd(zone, 1, blind_model());
    NewPerson person;
    person.position = {20, 10};
    person.destination = point(20, 10);
    const auto standing = crowd.add(person);
    crowd.step(0.1, {});
    const Vec2 place = crowd.view(standing).position;
    person.key = 2;
    person.position = {12, 10 + c.aside};
    person.destination = point(39, 10 + c.aside);
    const auto passing = crowd.add(person);
    double narrowest = 1e9, straight_at = 1e9;
    for (double time = 0.0; time < 12.0; time += 0.1) {
      crowd.step(0.1, {});
      const PersonView view = crowd.view(standing);
      if (time < kSettled) continue;
      EXPECT_TRUE(view.arrived);
      EXPECT_NEAR((view.position - place).norm(), 0.0, kRounding) << "nobody is pushed";
      narrowest = std::min(narrowest, view.radius);
      const bool straight = view.radius >= kRadius - kRounding;
      const double x = crowd.view(passing).position.x();
      straight_at = straight ? std::min(straight_at, x) : 1e9;
    }
    EXPECT_NEAR(narrowest, c.near ? kTurned : kRadius, kRounding);
    // Out of reach, and the time to turn back, 1 s.
    if (c.near) {
      const double beyond = std::sqrt(kTurnReach * kTurnReach - c.aside * c.aside);
      EXPECT_NEAR(straight_at, 20.0 + beyond + 1.34, 0.2);
    }
  }
}

// ---- straightening ------------------------------------------------------------------------------

/// Walks as it is told, and turns for so long.
class ToldModel : public WalkingModel {
 public:
  ToldModel(double until, double direction) : until_(until), direction_(direction) {}
  void prepare(const Snapshot& snapshot) override { snapshot_ = snapshot; }
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override {
    for (std::size_t i = first; i < last; ++i) {
      Decision& d = decisions[i];
      d = {.direction = direction_, .speed = snapshot_.persons->preferred_speed[i]};
      d.free_distance = 10.0;
      d.turns = *snapshot_.time < until_;
    }
  }

 private:
  double until_, direction_;
  Snapshot snapshot_;
};

/// The places of a block of people 0.28 m apart after they have straightened within that time [s].
/// Those of the outer rows are `strides` times as fast as who stands.
std::vector<Vec2> straightened(double turn_time, double speed, std::vector<double>& radii) {
  Zone zone = zone_of(box(0, 0, 40, 20));
  zone.parameters.turn_time = turn_time;
  Scene scene(zone, 1, std::make_unique<ToldModel>(1.0, 0.0));
  for (int k = 0; k < 25; ++k) {
    NewPerson person;
    person.position = {5 + 0.28 * (k % 5), 10 + 0.28 * (k / 5)};
    // The second half of the block walks, all alike.
    person.preferred_speed = k / 5 < 2 ? speed : 0.0;
    person.velocity = {person.preferred_speed, 0.0};
    person.destination = point(39, person.position.y());
    scene.add(person);
  }
  std::vector<Vec2> places;
  for (int step = 0; step < 60; ++step) {
    scene.step();
    EXPECT_LE(scene.worst_present_overlap(), kRounding);
    for (const auto& p : scene.people) places.push_back(p.view.position);
  }
  for (const auto& p : scene.people) radii.push_back(p.view.radius);
  return places;
}

TEST(Straightening, pushes_nobody) {
  for (const double speed : {0.0, 0.6}) {
    std::vector<double> with_radii, without_radii;
    const auto with = straightened(1.0, speed, with_radii);
    const auto without = straightened(1e12, speed, without_radii);
    double worst = 0.0;
    for (std::size_t k = 0; k < with.size(); ++k) {
      worst = std::max(worst, (with[k] - without[k]).norm());
    }
    EXPECT_LE(worst, kRounding) << speed;
    EXPECT_GT(*std::ranges::max_element(with_radii), kTurned + kRounding);
    EXPECT_NEAR(*std::ranges::max_element(without_radii), kTurned, kRounding);
  }
}

TEST(Straightening, beside_a_wall_pushes_nobody_either) {
  // The wall moves who grows at it, but only into room that nobody has.
  std::vector<Vec2> places[2];
  for (const double turn_time : {1.0, 1e12}) {
    Zone zone = zone_of(box(0, 0, 40, 20));
    zone.parameters.turn_time = turn_time;
    Scene scene(zone, 1, std::make_unique<ToldModel>(1.0, 0.0));
    for (const double y : {0.13, 0.40, 0.66}) {
      NewPerson person;
      person.position = {5, y};
      person.preferred_speed = 0.0;
      person.destination = point(39, y);
      scene.add(person);
    }
    scene.run(6.0);
    for (const auto& p : scene.people) places[turn_time > 1.0].push_back(p.view.position);
    EXPECT_LE(scene.worst_present_overlap(), kRounding);
  }
  EXPECT_NEAR((places[0][1] - places[1][1]).norm(), 0.0, kRounding);
  EXPECT_NEAR((places[0][2] - places[1][2]).norm(), 0.0, kRounding);
}

/// [s] from the last moment of turning until the body is as wide as ever.
double time_to_straighten(double turn_time, double radius, double turned_width) {
  Zone zone = zone_of(box(0, 0, 40, 20));
  zone.parameters.turn_time = turn_time;
  zone.parameters.turned_width = turned_width;
  Scene scene(zone, 1, std::make_unique<ToldModel>(1.0, 0.0));
  NewPerson person;
  person.position = {5, 10};
  person.radius = radius;
  person.destination = point(39, 10);
  scene.add(person);
  for (int step = 0; step < 10; ++step) {
    scene.step();
    EXPECT_NEAR(scene.people[0].view.radius, turned_width * radius, kRounding);
  }
  while (scene.people[0].view.radius < radius - kRounding && scene.time < 30.0) scene.step();
  return scene.time - 1.0;
}

TEST(Straightening, takes_the_time_to_turn_in_the_open) {
  for (const double time : {0.5, 1.0, 3.0}) {
    EXPECT_NEAR(time_to_straighten(time, 0.24, 0.5), time, 0.15) << time;
    EXPECT_NEAR(time_to_straighten(time, 0.35, 0.5), time, 0.15) << time;
    // Never slower by much than a body that was half as wide.
    EXPECT_LE(time_to_straighten(time, 0.24, 0.8), time + 0.15) << time;
  }
}

// ---- who cannot turn ----------------------------------------------------------------------------

TEST(Shoulders, of_profiles_that_cannot_turn_keep_their_width_in_a_crowd) {
  // Wide enough for one of them and somebody who turns, not for two straight bodies.
  constexpr double kWidth = 1.1;
  const Zone zone = zone_of(box(0, 0, 40, kWidth), {}, true);
  Scene scene(zone);
  const char* wide[] = {"wheelchair", "pram", "cyclist"};
  for (int k = 0; k < 9; ++k) {
    const bool east = k < 3;
    NewPerson person = member({east ? 5.0 + 4.0 * k : 18.0 + 3.0 * k - 9.0, 0.55},
                              line_at_x(east ? 39.5 : 0.5, 0, kWidth), 0);
    person.profile = profile(east ? wide[k] : "adult");
    person.radius = east ? 0.35 : kRadius;
    scene.add(person);
  }
  double narrowest = 1e9;
  for (const char* id : {"wheelchair", "pram", "cyclist"}) {
    EXPECT_EQ(profile(id)->turned_width, 1.0) << id;
  }
  while (scene.time < 40.0) {
    scene.step();
    for (std::size_t k = 0; k < scene.people.size() && scene.time > kSettled; ++k) {
      const auto& p = scene.people[k];
      if (k < 3) {
        EXPECT_NEAR(p.view.radius, p.given.radius, kRounding);
      } else {
        narrowest = std::min(narrowest, p.view.radius);
      }
    }
    EXPECT_LE(scene.worst_present_overlap(), 0.05);
  }
  EXPECT_NEAR(narrowest, kTurned, kRounding) << "the others do turn";
}

TEST(Shoulders, of_who_is_led_by_the_hand_stay_straight) {
  // Through a row of people, while a vehicle drives beside them, so that the hand is taken.
  const Zone zone = zone_of(box(0, 0, 101, 20), {}, true);
  Scene scene(zone);
  const auto adult = scene.add(member({5, 10}, line_at_x(100, 1, 19), 3));
  NewPerson small = member({5, 10.6}, line_at_x(100, 1, 19), 3);
  small.profile = profile("infant");
  small.radius = 0.15;
  small.preferred_speed = 0.8;
  const auto child = scene.add(small);
  std::vector<SeenPerson> seen;
  for (int row = 0; row < 12; ++row) {
    for (double y = 0.5; y < 20; y += 1.0) {
      seen.push_back({{10.0 + 1.5 * row, y + 0.5 * (row % 2)}, {0, 0}, 0.24});
    }
  }
  scene.crowd.see(seen);
  double held_for = 0.0, longest = 0.0, narrowest_adult = 1e9, narrowest_held = 1e9;
  while (scene.time < 25.0) {
    scene.vehicles = {vehicle_at({0.8 * scene.time, 3.0}, 0.0, 0.8)};
    scene.step();
    const auto& view = scene.people[child].view;
    held_for = view.holds_hand ? held_for + 0.1 : 0.0;
    longest = std::max(longest, held_for);
    narrowest_adult = std::min(narrowest_adult, scene.people[adult].view.radius);
    // It straightens within the time to turn, 1 s, where it has taken the hand while turned.
    if (held_for > 1.5) narrowest_held = std::min(narrowest_held, view.radius);
  }
  EXPECT_GT(longest, 10.0);
  EXPECT_LT(narrowest_adult, kRadius - kOverlap);
  EXPECT_NEAR(narrowest_held, 0.15, kRounding);
}

}  // namespace
}  // namespace pedzone::test
