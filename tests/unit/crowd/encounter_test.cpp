// People among each other.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kTouch = 1e-6;    // [m] rounding at walls
constexpr double kOverlap = 0.01;  // [m] the limit

double random_in(double low, double high, std::uint64_t k, std::uint64_t what) {
  return low + (high - low) * random_uniform(77, k, what, Purpose::kPlacement);
}

/// Of two who meet in the open: whether they pass without touching and without much delay.
bool head_on_pair_passes(const char* model) {
  Zone zone = zone_of(box(0, 0, 30, 10), {}, true);
  zone.model = model;
  Scene scene(zone);
  scene.add({2, 5}, line_at_x(28, 0, 10));
  scene.add({28, 5}, line_at_x(2, 0, 10));
  double worst = 0.0;
  while (scene.time < 40 && scene.arrived() < 2) {
    scene.step();
    worst = std::max(worst, scene.worst_overlap());
  }
  return scene.arrived() == 2 && worst <= kOverlap && scene.time < 26 / 1.34 * 1.15;
}

/// [s] until the last of eight who meet eight in a corridor gets through; 60 s where some do not.
double counterflow_time(const char* model, double width, std::uint64_t seed) {
  Zone zone = zone_of(box(0, 0, 40, width), {}, true);
  zone.model = model;
  Scene scene(zone, seed);
  for (int k = 0; k < 8; ++k) {
    const double y = random_in(0.3, width - 0.3, k, 1), its_y = random_in(0.3, width - 0.3, k, 2);
    scene.add({1.0 + 1.2 * k, y}, line_at_x(39, 0, width));
    scene.add({39.0 - 1.2 * k, its_y}, line_at_x(1, 0, width));
  }
  scene.run(60);
  EXPECT_GE(scene.least_wall_gap(), -kTouch);
  return scene.time;
}

TEST(Encounter, a_head_on_pair_passes_without_touching) {
  EXPECT_TRUE(head_on_pair_passes("heuristic"));
}

// People turn for those they run into whatever their model, and slip past: what tells those who
// mind nobody is that they touch and lose time.
TEST(Encounter, people_who_mind_nobody_do_not_pass_these_checks) {
  EXPECT_FALSE(head_on_pair_passes("constant-velocity"));
  double minding = 0.0, blind = 0.0;  // [s]
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    minding += counterflow_time("heuristic", 1.2, seed);
    blind += counterflow_time("constant-velocity", 1.2, seed);
  }
  EXPECT_LT(minding, 5 * (38 / 1.34 + 0.5));
  EXPECT_GT(blind, minding);
}

// Exactly head-on and without noise nothing but rounding breaks the symmetry: they may hesitate,
// but the walls and the bodies hold.
TEST(Encounter, an_exactly_symmetric_pair_does_not_overlap) {
  const Zone zone = zone_of(box(0, 0, 30, 10));
  Scene scene(zone);
  scene.add({2, 5}, line_at_x(28, 0, 10));
  scene.add({28, 5}, line_at_x(2, 0, 10));
  double worst = 0.0;
  while (scene.time < 60 && scene.arrived() < 2) {
    scene.step();
    worst = std::max(worst, scene.worst_overlap());
  }
  EXPECT_EQ(scene.arrived(), 2u);
  EXPECT_LE(worst, kOverlap);
}

TEST(Encounter, counterflow_in_a_narrow_corridor_gets_through) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    EXPECT_LT(counterflow_time("heuristic", 2.0, seed), 60.0) << "seed " << seed;
  }
}

TEST(Encounter, crossing_streams_get_through_without_much_delay) {
  const Zone zone = zone_of(box(0, 0, 30, 30), {}, true);
  Scene scene(zone);
  for (int k = 0; k < 20; ++k) {
    scene.add({random_in(1, 8, k, 1), random_in(12, 18, k, 2)}, line_at_x(29, 10, 20));
    scene.add({random_in(12, 18, k, 3), random_in(1, 8, k, 4)}, line_at_y(29, 10, 20));
  }
  scene.run(90);
  ASSERT_EQ(scene.arrived(), scene.people.size());
  double delay = 0.0;
  for (const auto& p : scene.people) delay += p.arrival_time - p.walked / 1.34;
  EXPECT_LT(delay / 40.0, 5.0);
}

/// 200 people on a plaza with two houses, in all directions.
class Plaza : public ::testing::Test {
 protected:
  Plaza() : zone(zone_of(box(0, 0, 40, 40), {box(14, 14, 20, 20), box(25, 22, 28, 30)}, true)) {}

  void fill(Scene& scene) const {
    const Destination sides[] = {line_at_x(39.5, 1, 39), line_at_x(0.5, 1, 39),
                                 line_at_y(39.5, 1, 39), line_at_y(0.5, 1, 39)};
    for (int k = 0; k < 200; ++k) {
      NewPerson person;
      person.key = 1000 + k;
      person.position = {random_in(1, 39, k, 5), random_in(1, 39, k, 6)};
      person.radius = random_in(0.19, 0.31, k, 7);
      person.preferred_speed = random_in(0.8, 1.8, k, 8);
      person.heading = random_in(-3, 3, k, 9);
      person.destination = sides[k % 4];
      person.place_freely = true;
      scene.add(person);
    }
  }

  Zone zone;
};

TEST_F(Plaza, all_arrive_inside_and_without_overlap) {
  for (const bool turning : {false, true}) {
    const Zone its_zone = turning ? zone : with_hard_bodies(zone);
    Scene scene(its_zone);
    fill(scene);
    EXPECT_LE(scene.worst_overlap(), 0.0);  // placed freely
    double worst = 0.0, worst_straight = 0.0;
    while (scene.time < 120 && scene.arrived() < scene.people.size()) {
      scene.step();
      worst = std::max(worst, scene.worst_present_overlap());
      worst_straight = std::max(worst_straight, scene.worst_overlap());
    }
    EXPECT_EQ(scene.arrived(), scene.people.size());
    EXPECT_LE(worst, kOverlap);
    if (turning) {
      EXPECT_GT(worst_straight, 0.05);  // some did turn
    } else {
      EXPECT_LE(worst_straight, kOverlap);
    }
    EXPECT_GE(scene.least_wall_gap(), -kTouch);
    EXPECT_LE(scene.worst_jump(), 0.15);
    for (const auto& p : scene.people) EXPECT_FALSE(p.view.gave_up);
  }
}

TEST_F(Plaza, one_second_steps_end_like_short_ones) {
  double mean[2] = {0.0, 0.0};
  for (const int which : {0, 1}) {
    Scene scene(zone);
    fill(scene);
    scene.run(120, which == 0 ? 0.1 : 1.0);
    ASSERT_EQ(scene.arrived(), scene.people.size());
    for (const auto& p : scene.people) mean[which] += p.arrival_time / 200;
  }
  EXPECT_NEAR(mean[1], mean[0] + 0.45, 0.5);  // arrivals are seen at the end of a step
}

TEST(Encounter, seen_persons_are_avoided_and_not_moved) {
  const Zone zone = zone_of(box(0, 0, 30, 10), {}, true);
  Scene scene(zone);
  const auto person = scene.add({2, 5}, line_at_x(28, 0, 10));
  std::vector<SeenPerson> seen{{{26, 5}, {-1.2, 0}, 0.24}, {{15, 4.8}, {0, 0}, 0.24}};
  double nearest = 1e9;
  for (; scene.time < 30 && scene.arrived() == 0;) {
    scene.crowd.see(seen);
    scene.step();
    for (SeenPerson& other : seen) {
      other.position += 0.1 * other.velocity;
      nearest = std::min(nearest, (other.position - scene.people[person].view.position).norm());
    }
  }
  EXPECT_EQ(scene.arrived(), 1u);
  EXPECT_GE(nearest, 0.48 - kOverlap);
}

}  // namespace
}  // namespace pedzone::test
