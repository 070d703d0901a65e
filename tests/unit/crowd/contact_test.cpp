// Bodies do not overlap, whatever happens to them.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/random.hpp"
#include "crowd/state/body_grid.hpp"
#include "crowd/state/wall_guard.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kTouch = 1e-6;
constexpr double kOverlap = 0.01;

double random_in(double low, double high, std::uint64_t k, std::uint64_t what) {
  return low + (high - low) * random_uniform(80, k, what, Purpose::kPlacement);
}

/// Bodies that want to stay where they are.
std::size_t add_standing(Scene& scene, const Vec2& place, double radius, std::uint64_t key = 0) {
  NewPerson person;
  person.key = key;
  person.position = place;
  person.radius = radius;
  person.preferred_speed = 0.0;
  person.destination = point(place.x() + 15.0, place.y());
  return scene.add(person);
}

/// Bodies are kept apart as wide as they are at the moment. Where nobody turns, that is their full
/// width.
double worst_overlap(const Scene& scene) {
  if (scene.zone.parameters.turned_width == 1.0) return scene.worst_overlap();
  return scene.worst_present_overlap();
}

struct PileOf {
  int count;
  double turned_width;
};

class Pile : public ::testing::TestWithParam<PileOf> {
 protected:
  static Zone square() {
    Zone zone = zone_of(box(0, 0, 40, 40));
    zone.parameters.turned_width = GetParam().turned_width;
    return zone;
  }
};

TEST_P(Pile, comes_apart_in_the_open) {
  const Zone zone = square();
  Scene scene(zone);
  const int count = GetParam().count;
  for (int k = 0; k < count; ++k) add_standing(scene, {20, 20}, 0.24);
  for (int k = 0; k < 10 * count; ++k) scene.step();
  EXPECT_LE(worst_overlap(scene), kOverlap);
  for (const auto& p : scene.people) EXPECT_TRUE(p.view.position.allFinite());
}

TEST_P(Pile, comes_apart_in_a_corner_inside_the_walls) {
  const Zone zone = square();
  Scene scene(zone);
  const int count = GetParam().count;
  for (int k = 0; k < count; ++k) add_standing(scene, {0.01 * (k % 3), 0.3}, 0.24);
  for (int k = 0; k < 20 * count; ++k) scene.step();
  EXPECT_LE(worst_overlap(scene), kOverlap);
  // Walls give room to who straightens at them step by step: it may lack what it has grown by in
  // one of 0.1 s, when half of its width takes 1 s.
  const double growth = 0.1 * (1.0 - GetParam().turned_width) * 0.24;
  EXPECT_GE(scene.least_wall_gap(), -growth - kTouch);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Pile,
                         ::testing::Values(PileOf{2, 1.0}, PileOf{3, 1.0}, PileOf{10, 1.0},
                                           PileOf{40, 1.0}, PileOf{2, 0.5}, PileOf{10, 0.5},
                                           PileOf{40, 0.5}),
                         [](const auto& test) {
                           return std::to_string(test.param.count) +
                                  (test.param.turned_width < 1.0 ? "_turned" : "_hard");
                         });

/// Of people whose bodies are that share as wide with their shoulders turned.
class ContactOf : public ::testing::TestWithParam<double> {
 protected:
  static Zone with_bodies(Zone zone) {
    zone.parameters.turned_width = GetParam();
    return zone;
  }
};

TEST_P(ContactOf, two_with_the_same_key_and_place_part) {
  const Zone zone = with_bodies(zone_of(box(0, 0, 40, 40)));
  Scene scene(zone);
  add_standing(scene, {20, 20}, 0.3, 9);
  add_standing(scene, {20, 20}, 0.3, 9);
  for (int k = 0; k < 20; ++k) scene.step();
  EXPECT_LE(worst_overlap(scene), kOverlap);
  const auto &a = scene.people[0].view, &b = scene.people[1].view;
  EXPECT_GE((a.position - b.position).norm(), GetParam() * 2 * 0.3 - kOverlap);
}

TEST_P(ContactOf, a_standing_body_is_not_shoved_by_one_that_walks_into_it) {
  const Zone zone = with_bodies(zone_of(box(0, 0, 40, 10)));
  Scene scene(zone, 1, blind_model());
  const auto standing = add_standing(scene, {20, 5}, 0.24);
  const auto walking = scene.add({15, 5}, line_at_x(39, 0, 10));
  for (int k = 0; k < 100; ++k) {
    scene.step();
    EXPECT_LE(worst_overlap(scene), 1e-6);
  }
  EXPECT_NEAR(scene.people[standing].view.position.x(), 20, 0.05);
  EXPECT_LT(scene.people[walking].view.position.x(), 20);
}

TEST_P(ContactOf, fast_bodies_do_not_pass_through_each_other) {
  const Zone zone = with_bodies(zone_of(box(0, 0, 40, 2.0)));
  Scene scene(zone, 1, blind_model());
  const auto a = scene.add({10, 1}, line_at_x(39, 0, 2), 5.0);
  const auto b = scene.add({30, 1}, line_at_x(1, 0, 2), 5.0);
  for (int k = 0; k < 40; ++k) {
    scene.step();
    ASSERT_LT(scene.people[a].view.position.x(), scene.people[b].view.position.x());
  }
  EXPECT_LE(worst_overlap(scene), kOverlap);
}

TEST_P(ContactOf, a_blind_crowd_that_presses_at_a_gap_stays_inside_and_apart) {
  const Zone zone =
      with_bodies(zone_of(box(0, 0, 30, 12), {box(20, -1, 20.5, 5.6), box(20, 6.6, 20.5, 13)}));
  Scene scene(zone, 1, blind_model());
  for (int k = 0; k < 80; ++k) {
    NewPerson person;
    person.position = {random_in(2, 18, k, 1), random_in(1, 11, k, 2)};
    person.destination = line_at_x(29, 0, 12);
    person.place_freely = true;
    scene.add(person);
  }
  double worst = 0.0;
  while (scene.time < 120 && scene.arrived() < scene.people.size()) {
    scene.step();
    worst = std::max(worst, worst_overlap(scene));
    for (const auto& p : scene.people) ASSERT_TRUE(p.view.position.allFinite());
  }
  EXPECT_GE(scene.least_wall_gap(), -kTouch);
  EXPECT_LE(worst, 0.05);  // 80 people press with all their speed; who looks keeps 1 cm (Plaza)
}

INSTANTIATE_TEST_SUITE_P(Bodies, ContactOf, ::testing::Values(1.0, 0.5), [](const auto& test) {
  return std::string(test.param < 1.0 ? "turned" : "hard");
});

TEST(Contact, absurd_input_gives_no_nan) {
  const Zone zone = zone_of(box(0, 0, 20, 20), {box(8, 8, 12, 12)}, true);
  Scene scene(zone);
  const Vec2 places[] = {{0, 0}, {10, 10}, {8, 8}, {-100, 1e6}, {20, 20}, {5, 5}, {5, 5}};
  for (std::uint64_t k = 0; k < 42; ++k) {
    NewPerson person;
    person.position = places[k % 7];
    person.velocity = {1e9, -1e9};
    person.heading = 1e6;
    person.radius = k % 2 == 0 ? 0.0 : 50.0;
    person.preferred_speed = k % 3 == 0 ? -1.0 : 1e9;
    person.destination = k % 2 == 0 ? point(1e7, -1e7) : Destination{{10, 10}, {10, 10}};
    scene.add(person);
  }
  scene.vehicles = {vehicle_at({5, 5}, 1e5, 30.0, 0.0, 0.0), vehicle_at({10, 10}, 0.1, 0.0, 50, 50),
                    vehicle_at({-1e9, 3}, 0.0, 1e9, 1e12, 0.5)};
  for (int k = 0; k < 50; ++k) {
    scene.step(0.7);
    for (const auto& p : scene.people) {
      ASSERT_TRUE(p.view.position.allFinite());
      ASSERT_TRUE(p.view.velocity.allFinite());
      ASSERT_TRUE(std::isfinite(p.view.heading));
      ASSERT_TRUE(zone.walls.inside(p.view.position));
    }
  }
}

TEST(Placement, people_on_one_point_get_free_places_near_it) {
  const Zone zone = zone_of(box(0, 0, 40, 40));
  Scene scene(zone);
  scene.crowd.see(std::vector<SeenPerson>{{{20.3, 20}, {0, 0}, 0.3}});
  for (int k = 0; k < 50; ++k) {
    NewPerson person;
    person.position = {20, 20};
    person.destination = line_at_x(39, 0, 40);
    person.place_freely = true;
    const auto i = scene.add(person);
    const Vec2 place = scene.people[i].view.position;
    EXPECT_LE((place - Vec2(20, 20)).norm(), 3.0);
    EXPECT_GE((place - Vec2(20.3, 20)).norm(), 0.54 - kTouch);
  }
  EXPECT_LE(scene.worst_overlap(), kTouch);  // places 0.48 m apart; radii are kept as floats
}

TEST(Placement, never_lies_behind_a_wall) {
  const Zone zone = zone_of(box(0, 0, 40, 40), {box(20, -1, 20.3, 38)});
  Scene scene(zone);
  for (int k = 0; k < 30; ++k) {
    NewPerson person;
    person.position = {19.5, 10};
    person.destination = line_at_x(39, 0, 40);
    person.place_freely = true;
    const auto i = scene.add(person);
    EXPECT_LT(scene.people[i].view.position.x(), 20.0);
  }
}

TEST(Placement, finds_places_in_a_lane_narrower_than_the_body) {
  const Zone zone = zone_of(box(0, 0, 40, 0.5));
  Scene scene(zone);
  for (int k = 0; k < 5; ++k) {
    NewPerson person;
    person.position = {20, 0.25};
    person.radius = 0.3;
    person.destination = line_at_x(39, 0, 0.5);
    person.place_freely = true;
    scene.add(person);
  }
  EXPECT_LE(scene.worst_overlap(), 0.0);
}

TEST(Placement, avoids_vehicles_of_the_last_step) {
  const Zone zone = zone_of(box(0, 0, 40, 40));
  Scene scene(zone);
  scene.vehicles = {vehicle_at({20, 20}, 0.5, 0.0)};
  scene.step();
  NewPerson person;
  person.position = {20, 20};
  person.destination = line_at_x(39, 0, 40);
  person.place_freely = true;
  const auto i = scene.add(person);
  EXPECT_GE(clearance(scene.vehicles[0], scene.people[i].view.position), 0.24);
}

TEST(Placement, avoids_where_a_vehicle_got_to_while_nobody_was_there) {
  const Zone zone = zone_of(box(0, 0, 40, 40));
  Scene scene(zone);
  VehicleState car = vehicle_at({15, 20}, 0.0, 5.0);
  scene.crowd.step(1.0, std::vector<VehicleState>{car});
  NewPerson person;
  person.position = {20, 20};
  person.destination = line_at_x(39, 0, 40);
  person.place_freely = true;
  const auto i = scene.add(person);
  car.centre.x() += 5.0;
  EXPECT_GE(clearance(car, scene.people[i].view.position), 0.24);
}

TEST(BodyGrid, finds_all_that_are_near_and_each_once) {
  std::vector<double> x, y;
  for (std::uint64_t k = 0; k < 3000; ++k) {
    // A dense patch, a sparse town and somebody very far away.
    const double spread = k < 1500 ? 15.0 : k < 2999 ? 2000.0 : 1e8;
    x.push_back(random_in(-spread, spread, k, 1));
    y.push_back(random_in(-spread, spread, k, 2));
  }
  BodyGrid grid;
  grid.build(x, y, 1.1);
  for (std::size_t i = 0; i < x.size(); i += 7) {
    const Vec2 here(x[i], y[i]);
    for (const double reach : {1.1, 8.0, 100.0}) {
      std::multiset<std::uint32_t> found;
      grid.visit_box(here - Vec2::Constant(reach), here + Vec2::Constant(reach),
                     [&](std::uint32_t j, const Vec2&) { found.insert(j); });
      for (std::uint32_t j = 0; j < x.size(); ++j) {
        const bool near = std::max(std::abs(x[j] - x[i]), std::abs(y[j] - y[i])) <= reach;
        ASSERT_EQ(found.count(j), near ? 1u : 0u);
      }
    }
  }
}

TEST(WallGuard, keeps_a_body_inside_and_looks_only_when_it_must) {
  const Zone zone = zone_of(box(0, 0, 40, 40));
  WallRoom room;
  Vec2 at(20, 20);
  for (int k = 0; k < 1000; ++k) {
    const Vec2 to = at + 0.13 * unit(random_in(-kPi, kPi, k, 3)) + Vec2(0.05, 0.02);
    const Vec2 next = kept_inside(zone.walls, at, to, 0.24, room);
    EXPECT_LE((next - at).norm(), (to - at).norm() + 1e-9);
    room.spend((next - at).norm());
    at = next;
    const double true_room = std::min({at.x(), at.y(), 40 - at.x(), 40 - at.y()});
    ASSERT_LE(room.distance, true_room + 1e-9);
    ASSERT_GE(true_room, 0.24 - kTouch);
  }
}

}  // namespace
}  // namespace pedzone::test
