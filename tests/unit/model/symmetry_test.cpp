// What must not change a decision: mirroring, turning and moving the scene, the order of people.
// (Threads, ranges and the calls before: models_test.cpp.)
#include <gtest/gtest.h>

#include <algorithm>

#include "oracle.hpp"
#include "same_decision.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

Scene crowded(std::uint32_t seed) {
  // Places on a lattice of 1/1024 m, so that moving the scene costs no digits.
  Scene scene = random_scene({.people = 400, .density = 0.8, .vehicles = 6, .obstacles = 6}, seed);
  const auto round = [](Vec2& v) {
    v.x() = std::round(v.x() * 1024.0) / 1024.0;
    v.y() = std::round(v.y() * 1024.0) / 1024.0;
  };
  for (PersonSpec& p : scene.people) round(p.at);
  for (VehicleState& v : scene.vehicles) round(v.centre);
  for (Wall& w : scene.walls) {
    round(w.a);
    round(w.b);
  }
  return scene;
}

template <class Point, class Direction>
Scene transformed(Scene scene, Point&& point, Direction&& direction) {
  const auto angle = [&](double a) { return angle_of(direction(unit(a))); };
  for (PersonSpec& p : scene.people) {
    p.at = point(p.at);
    p.velocity = direction(p.velocity);
    p.heading = angle(p.heading);
    p.goal = angle(p.goal);
  }
  for (VehicleState& v : scene.vehicles) {
    v.centre = point(v.centre);
    v.velocity = direction(v.velocity);
    v.heading = angle(v.heading);
  }
  for (Wall& w : scene.walls) w = {point(w.a), point(w.b)};
  return scene;
}

TEST(Symmetry, a_mirrored_scene_gives_mirrored_decisions_to_the_bit) {
  int minded = 0, slowed = 0;  // for whom vehicles count as more than obstacles, who slows down
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    Scene scene = crowded(seed);
    Scene mirror = scene;
    for (PersonSpec& p : mirror.people) {
      p.at.y() = -p.at.y();
      p.velocity.y() = -p.velocity.y();
      p.heading = -p.heading;
      p.goal = -p.goal;
    }
    for (VehicleState& v : mirror.vehicles) {
      v.centre.y() = -v.centre.y();
      v.velocity.y() = -v.velocity.y();
      v.heading = -v.heading;
    }
    for (Wall& w : mirror.walls) {
      w.a.y() = -w.a.y();
      w.b.y() = -w.b.y();
      std::swap(w.a, w.b);  // the walkable side is the left one
    }
    Scene paper = scene;
    paper.model_name = "plain";
    const std::vector<Decision> a = scene.decide(), b = mirror.decide(), c = paper.decide();
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double walks =
          std::min(scene.people[i].speed, a[i].free_distance / scene.parameters.collision_time);
      minded += a[i].direction != c[i].direction ? 1 : 0;
      slowed += a[i].speed < walks - 1e-6 ? 1 : 0;
      // At exactly ±180° left and right are one direction.
      ASSERT_NEAR(wrap_angle(a[i].direction + b[i].direction), 0.0, 1e-15) << i;
      ASSERT_EQ(a[i].speed, b[i].speed) << i;
      ASSERT_EQ(a[i].free_distance, b[i].free_distance) << i;
      ASSERT_EQ(a[i].waits, b[i].waits) << i;
      ASSERT_EQ(a[i].turns, b[i].turns) << i;
    }
  }
  EXPECT_GT(minded, 200);
  EXPECT_GT(slowed, 50);
}

TEST(Symmetry, in_a_symmetric_scene_people_pass_on_the_right) {
  // Two head-on: each is the other's mirror image, and left is as good as right.
  Scene scene;
  scene.people = {walking_to({0, 0}, 0.0), walking_to({8, 0}, kPi)};
  scene.people[0].heading = scene.people[0].goal = 0.0;
  const std::vector<Decision> d = scene.decide();
  EXPECT_LT(d[0].direction, 0.0);
  EXPECT_GT(d[1].direction, 0.0);  // heading west, right is north
  EXPECT_NEAR(d[0].direction, d[1].direction - kPi, 1e-6);
}

TEST(Symmetry, a_moved_scene_gives_the_same_decisions_to_the_bit) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = crowded(seed);
    const Vec2 shift(1234.0 + 17.0 * seed, -8000.5);
    const Scene moved = transformed(
        scene, [&](const Vec2& p) -> Vec2 { return p + shift; },
        [](const Vec2& d) -> Vec2 { return d; });
    const std::vector<Decision> a = scene.decide();
    Scene same_angles = moved;  // unit() and angle_of() cost a last digit
    for (std::size_t i = 0; i < scene.people.size(); ++i) {
      same_angles.people[i].heading = scene.people[i].heading;
      same_angles.people[i].goal = scene.people[i].goal;
    }
    for (std::size_t i = 0; i < scene.vehicles.size(); ++i) {
      same_angles.vehicles[i].heading = scene.vehicles[i].heading;
    }
    const std::vector<Decision> b = same_angles.decide();
    for (std::size_t i = 0; i < a.size(); ++i) expect_equal(a[i], b[i], i);
  }
}

TEST(Symmetry, a_turned_scene_gives_turned_decisions) {
  // Directions are a grid about the heading, so they turn with the person. Rounding can only
  // decide between directions of nearly equal value: rare, and then as free a way.
  std::size_t different = 0, all = 0;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = crowded(seed);
    const double angle = 0.7 * seed;
    const Vec2 centre = scene.people[0].at;
    const auto turn = [&](const Vec2& v) -> Vec2 {
      const Vec2 u = unit(angle);
      return {v.x() * u.x() - v.y() * u.y(), v.x() * u.y() + v.y() * u.x()};
    };
    const Scene turned = transformed(
        scene, [&](const Vec2& p) -> Vec2 { return centre + turn(p - centre); }, turn);
    const std::vector<Decision> a = scene.decide(), b = turned.decide();
    for (std::size_t i = 0; i < a.size(); ++i) {
      ++all;
      const double off = wrap_angle(b[i].direction - a[i].direction - angle);
      if (std::abs(off) > 1e-6 || std::abs(a[i].free_distance - b[i].free_distance) > 0.02) {
        ++different;
      }
    }
  }
  EXPECT_LT(static_cast<double>(different), 0.005 * static_cast<double>(all));
}

TEST(Symmetry, the_order_of_people_and_vehicles_does_not_matter_to_the_bit) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    Scene scene = crowded(seed);
    for (std::size_t i = 0; i < scene.people.size(); ++i) scene.people[i].key = i + 1;
    const Shuffled other = shuffled(scene, seed);
    const std::vector<Decision> a = scene.decide(), b = other.scene.decide();
    for (std::size_t i = 0; i < b.size(); ++i) expect_equal(b[i], a[other.order[i]], i);
  }
}

TEST(Symmetry, parameters_changed_between_steps_count_from_then_on) {
  const auto model = make_model("heuristic");
  Scene scene = crowded(3);
  (void)scene.decide(*model);
  scene.parameters.sight = 4.0;
  scene.parameters.field_of_view = 50.0;
  scene.parameters.candidate_field = 40.0;
  const std::vector<Decision> a = scene.decide(*model), b = scene.decide();
  for (std::size_t i = 0; i < a.size(); ++i) expect_equal(a[i], b[i], i);
}

}  // namespace
}  // namespace pedzone::test
