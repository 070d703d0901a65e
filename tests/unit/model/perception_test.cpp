// Who and what a person is aware of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "model/person_grid.hpp"
#include "model/trigonometry.hpp"
#include "model/vehicle_view.hpp"
#include "model/wall_tiles.hpp"
#include "oracle.hpp"
#include "scene.hpp"
#include "world/model_names.hpp"

namespace pedzone::test {
namespace {

constexpr double kDegree = kPi / 180.0;

/// Whether the walker at the origin, heading east, makes way for somebody who comes at it.
bool reacts_to_person(const Vec2& at, const Parameters& parameters = Parameters()) {
  Scene scene;
  scene.parameters = parameters;
  scene.people = {walking_to({0, 0}, 0.0), walking_to(at, angle_of(-at))};
  // Both would be at the same place: the other walks to where the first one will be.
  scene.people[1].velocity = (Vec2(1.34 * 3.0, 0.0) - at) / 3.0;
  const Decision d = scene.first();
  return d.direction != 0.0 || d.free_distance < parameters.sight - 0.1;
}

TEST(Perception, reaches_as_far_as_sight) {
  EXPECT_TRUE(reacts_to_person({9.9, 0.3}));
  EXPECT_FALSE(reacts_to_person({10.1, 0.3}));
  Parameters p;
  p.sight = 5.0;
  EXPECT_TRUE(reacts_to_person({4.9, 0.3}, p));
  EXPECT_FALSE(reacts_to_person({5.1, 0.3}, p));
}

TEST(Perception, of_persons_is_confined_to_the_field_of_view) {
  Parameters p;
  for (const double half : {60.0, 75.0, 90.0, 120.0}) {
    p.field_of_view = half;
    for (const double side : {-1.0, 1.0}) {
      EXPECT_TRUE(reacts_to_person(2.0 * unit(side * (half - 1.0) * kDegree), p)) << half;
      EXPECT_FALSE(reacts_to_person(2.0 * unit(side * (half + 1.0) * kDegree), p)) << half;
    }
  }
}

/// Whether a walker heading east reacts to a vehicle that comes up from behind in its track.
bool reacts_to_vehicle_behind(double gap, double speed, const Parameters& parameters) {
  Scene scene;
  scene.parameters = parameters;
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.vehicles = {vehicle({-gap - 2.5, 1.0}, 0.0, speed)};
  const Decision d = scene.first();
  return d.direction != 0.0;
}

TEST(Perception, a_moving_vehicle_behind_is_heard_within_hearing) {
  Parameters p;
  EXPECT_TRUE(reacts_to_vehicle_behind(7.9, 4.0, p));
  EXPECT_FALSE(reacts_to_vehicle_behind(8.1, 4.0, p));
  p.hearing = 3.0;
  EXPECT_TRUE(reacts_to_vehicle_behind(2.9, 4.0, p));
  EXPECT_FALSE(reacts_to_vehicle_behind(3.1, 4.0, p));
  p.hearing = 0.0;
  EXPECT_FALSE(reacts_to_vehicle_behind(0.5, 4.0, p));
}

TEST(Perception, a_fast_vehicle_is_heard_from_afar) {
  const Parameters p;
  EXPECT_TRUE(reacts_to_vehicle_behind(20.0, 10.0, p));
  EXPECT_FLOAT_EQ(loudness_of(2.0F, false), 1.0F);
  EXPECT_FLOAT_EQ(loudness_of(2.0F, true), 0.5F);
  EXPECT_NEAR(loudness_of(8.4F, false), std::pow(2.0, 1.5), 1e-5);  // 9 dB more
  EXPECT_FLOAT_EQ(loudness_of(8.4F, true), loudness_of(8.4F, false)) << "tyres";
}

TEST(Perception, hearing_reaches_beyond_sight_where_it_is_farther) {
  Parameters p;
  p.sight = 6.0;
  p.hearing = 9.0;
  EXPECT_TRUE(reacts_to_vehicle_behind(8.5, 5.0, p));
}

TEST(Perception, a_vehicle_is_seen_when_any_part_of_it_is_in_view) {
  // Its middle is behind the person, its front ahead of it, on a course that closes in.
  Scene scene;
  scene.parameters.hearing = 0.0;
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.people[0].goal = 30.0 * kDegree;
  VehicleState v = vehicle({-2.0, 2.0}, 0.0, 1.3, 5.0, 2.0);
  scene.vehicles = {v};
  const double seen = scene.first().direction;
  scene.vehicles[0].centre.x() = -3.0;  // 0.5 m behind now, and unheard
  const double unseen = scene.first().direction;
  EXPECT_NEAR(unseen, 30.0 * kDegree, 1.3 * kDegree);
  EXPECT_LT(seen, 25.0 * kDegree);
}

TEST(Perception, a_parked_vehicle_is_a_static_obstacle_all_round) {
  // Its goal lies behind it, and behind a parked car: by Eq. 2 it walks round the car.
  Scene scene;
  scene.model_name = "plain";
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.people[0].goal = kPi;
  scene.vehicles = {vehicle({-3.0, 0.0}, kPi / 2, 0.0, 4.0, 2.0)};
  const Decision d = scene.first();
  EXPECT_LT(std::abs(d.direction), 170.0 * kDegree);
  EXPECT_GT(d.free_distance, 5.0);
  EXPECT_FALSE(d.waits);
}

TEST(Perception, the_grid_finds_everybody_in_view) {
  for (const double half_field : {0.3, kPi / 2, 2.5, kPi}) {
    for (const double density : {3.0, 0.3, 0.00001}) {
      const Scene scene = random_scene({.people = 200, .density = density}, 7);
      const Persons persons = persons_of(scene.people);
      const LatticeOrigin origin{to_lattice(6990.0), to_lattice(-3050.0)};
      PersonGrid grid;
      grid.build(persons, origin, 10.0, half_field);
      ASSERT_EQ(grid.size(), persons.size());
      std::vector<SlotGroup> space;
      for (std::size_t i = 0; i < persons.size(); ++i) {
        const LatticePoint at = to_lattice(persons.x[i], persons.y[i], origin);
        std::set<std::pair<std::int32_t, std::int32_t>> found;
        for (const SlotGroup& g : grid.groups(at, persons.heading[i], space)) {
          for (std::uint32_t s = 0; s < kSlotGroup; ++s) {
            if ((g.used >> s & 1U) == 0) continue;
            found.emplace(grid.slots().x[g.first + s], grid.slots().y[g.first + s]);
          }
        }
        for (std::size_t j = 0; j < persons.size(); ++j) {
          const Vec2 d = scene.people[j].at - scene.people[i].at;
          if (j == i || d.norm() > 10.0) continue;
          if (std::abs(wrap_angle(angle_of(d) - persons.heading[i])) > half_field) continue;
          const LatticePoint p = to_lattice(persons.x[j], persons.y[j], origin);
          EXPECT_TRUE(found.contains({p.x, p.y})) << i << " sees " << j;
        }
      }
    }
  }
}

TEST(Perception, the_tiles_list_every_wall_within_reach) {
  const Scene scene = random_scene({.people = 400, .density = 0.1, .obstacles = 60}, 3);
  const LatticeOrigin origin{to_lattice(7000.0), to_lattice(-3000.0)};
  WallTiles tiles;
  tiles.build(scene.walls, 6.0, origin);
  std::size_t listed = 0;
  for (const PersonSpec& p : scene.people) {
    const auto near = tiles.near(to_lattice(p.at.x(), p.at.y(), origin));
    listed += near.size();
    for (std::uint32_t w = 0; w < scene.walls.size(); ++w) {
      const bool there = std::find(near.begin(), near.end(), w) != near.end();
      const double distance = distance_to(scene.walls[w], p.at);
      EXPECT_TRUE(there || distance > 6.0) << w;
      EXPECT_FALSE(there && distance > 12.0) << w;
    }
  }
  EXPECT_GT(listed, 0U);
}

TEST(Perception, sees_walls_that_came_with_another_index) {
  const auto model = make_model("heuristic");
  Scene scene;
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.walls = {{{2.0, -0.5}, {2.0, 0.5}}};
  EXPECT_NE(scene.decide(*model)[0].direction, 0.0);
  scene.walls = {{{-2.0, -0.5}, {-2.0, 0.5}}};
  EXPECT_EQ(scene.decide(*model)[0].direction, 0.0);
  scene.walls.clear();
  EXPECT_EQ(scene.decide(*model)[0].direction, 0.0);
}

TEST(Perception, copes_with_nobody_and_with_people_on_one_spot) {
  Scene scene;
  EXPECT_TRUE(scene.decide().empty());
  scene.people = {walking_to({5, 5}, 1.0), walking_to({5, 5}, 1.0), walking_to({5, 5}, -1.0)};
  for (const Decision& d : scene.decide()) {
    EXPECT_TRUE(std::isfinite(d.direction));
    EXPECT_GE(d.speed, 0.0);
    EXPECT_LE(d.speed, 1.34);
  }
}

TEST(Perception, an_unknown_model_is_refused_with_the_known_names) {
  for (const std::string_view name : kModelNames) EXPECT_NE(make_model(std::string(name)), nullptr);
  try {
    make_model("telepathy");
    FAIL() << "accepted";
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("telepathy"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("heuristic"), std::string::npos);
  }
}

TEST(Trigonometry, is_as_good_as_the_library_and_exactly_symmetric) {
  for (double a = -2.0 * kPi; a <= 2.0 * kPi; a += 0.001237) {
    const SineCosine s = sine_cosine(a), m = sine_cosine(-a);
    EXPECT_NEAR(s.sin, std::sin(a), 2e-11);
    EXPECT_NEAR(s.cos, std::cos(a), 2e-11);
    EXPECT_EQ(s.sin, -m.sin);
    EXPECT_EQ(s.cos, m.cos);
  }
}

}  // namespace
}  // namespace pedzone::test
