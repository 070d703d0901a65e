// What every walking model must do, whatever its rules.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "same_decision.hpp"
#include "scene.hpp"
#include "world/model_names.hpp"

namespace pedzone::test {
namespace {

class Models : public ::testing::TestWithParam<std::string_view> {
 protected:
  std::string name() const { return std::string(GetParam()); }
  /// Minds nothing but its goal.
  bool blind() const { return GetParam() == "constant-velocity"; }

  Scene empty_scene() const {
    Scene scene;
    scene.model_name = name();
    return scene;
  }
  Scene crowded(std::uint32_t seed) const {
    Scene scene =
        random_scene({.people = 250, .density = 0.8, .vehicles = 4, .obstacles = 4}, seed);
    scene.model_name = name();
    for (std::size_t i = 0; i < scene.people.size(); ++i) scene.people[i].key = i + 1;
    return scene;
  }
};

Vec2 velocity_of(const Decision& decision) { return decision.speed * unit(decision.direction); }

Vec2 mirrored(const Vec2& v) { return {v.x(), -v.y()}; }

Vec2 turned(const Vec2& v, double angle) {
  const Vec2 u = unit(angle);
  return {v.x() * u.x() - v.y() * u.y(), v.x() * u.y() + v.y() * u.x()};
}

Scene mirrored(Scene scene) {
  for (PersonSpec& p : scene.people) {
    p.at = mirrored(p.at);
    p.velocity = mirrored(p.velocity);
    p.heading = -p.heading;
    p.goal = -p.goal;
  }
  for (VehicleState& v : scene.vehicles) {
    v.centre = mirrored(v.centre);
    v.velocity = mirrored(v.velocity);
    v.heading = -v.heading;
  }
  for (Wall& w : scene.walls) w = {mirrored(w.b), mirrored(w.a)};  // walkable to the left
  return scene;
}

Scene turned(Scene scene, double angle) {
  const Vec2 centre = scene.people.front().at;
  const auto place = [&](const Vec2& p) -> Vec2 { return centre + turned(p - centre, angle); };
  for (PersonSpec& p : scene.people) {
    p.at = place(p.at);
    p.velocity = turned(p.velocity, angle);
    p.heading += angle;
    p.goal += angle;
  }
  for (VehicleState& v : scene.vehicles) {
    v.centre = place(v.centre);
    v.velocity = turned(v.velocity, angle);
    v.heading += angle;
  }
  for (Wall& w : scene.walls) w = {place(w.a), place(w.b)};
  return scene;
}

/// Share of the people whose velocities differ by more than that [m/s]. Rounding may decide where a
/// model chooses between places or directions of nearly the same value.
constexpr double kSame = 1e-3;
template <class Transform>
double share_of_others(const std::vector<Decision>& a, const std::vector<Decision>& b,
                       const Transform& transform) {
  std::size_t others = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if ((transform(velocity_of(a[i])) - velocity_of(b[i])).norm() > kSame) ++others;
  }
  return static_cast<double>(others) / static_cast<double>(a.size());
}

constexpr double kRare = 0.02;

TEST_P(Models, alone_people_walk_to_their_goal_at_their_speed) {
  Scene scene = empty_scene();
  scene.people = {walking_to({100.0, 50.0}, 0.7)};
  const Decision d = scene.first();
  EXPECT_NEAR(wrap_angle(d.direction - 0.7), 0.0, 0.02);
  EXPECT_NEAR(d.speed, 1.34, 0.02);
}

TEST_P(Models, from_rest_people_get_going_towards_their_goal) {
  Scene scene = empty_scene();
  scene.people = {walking_to({0.0, 0.0}, -2.0)};
  scene.people[0].velocity = Vec2::Zero();
  const Decision d = scene.first();
  EXPECT_NEAR(wrap_angle(d.direction + 2.0), 0.0, 0.02);
  EXPECT_GT(d.speed, 0.1);
}

/// Of the preferred speed: the default model hurries before vehicles.
double most_share(std::string_view model) { return model == "heuristic" ? 1.2 : 1.0; }

TEST_P(Models, nobody_is_faster_than_it_likes_or_hurries_and_all_is_a_number) {
  const double most = most_share(GetParam());
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const Scene scene = crowded(seed);
    const std::vector<Decision> decisions = scene.decide();
    for (std::size_t i = 0; i < decisions.size(); ++i) {
      ASSERT_TRUE(std::isfinite(decisions[i].direction)) << i;
      ASSERT_GE(decisions[i].speed, 0.0) << i;
      ASSERT_LE(decisions[i].speed, most * scene.people[i].speed + 1e-6) << i;
      ASSERT_GE(decisions[i].free_distance, 0.0) << i;
    }
  }
}

TEST_P(Models, people_and_things_in_one_place_give_numbers) {
  Scene scene = empty_scene();
  EXPECT_TRUE(scene.decide().empty());
  const PersonSpec there = walking_to({5.0, 5.0}, 1.0);
  scene.people = {there, there, walking_to({5.0, 5.0}, -1.0), walking_to({5.1, 5.0}, 2.0)};
  scene.people[1].goal_distance = 0.0;
  scene.vehicles = {vehicle({5.0, 5.0}, 0.5, 2.0), vehicle({5.0, 6.0}, 0.5, 0.0)};
  scene.walls = {{{0.0, 5.0}, {10.0, 5.0}}};
  for (const Decision& d : scene.decide()) {
    EXPECT_TRUE(std::isfinite(d.direction));
    EXPECT_GE(d.speed, 0.0);
    EXPECT_LE(d.speed, 1.34 * most_share(GetParam()) + 1e-6);
  }
}

TEST_P(Models, a_person_in_the_way_on_the_left_is_passed_on_the_right) {
  Scene scene = empty_scene();
  scene.people = {walking_to({0.0, 0.0}, 0.0), walking_to({0.6, 0.25}, 0.0)};
  scene.people[1].velocity = Vec2::Zero();
  const Vec2 right = velocity_of(scene.first()), left = velocity_of(mirrored(scene).first());
  if (blind()) {
    EXPECT_EQ(right.y(), 0.0);
    return;
  }
  EXPECT_LT(right.y(), -0.01);
  EXPECT_GT(left.y(), 0.01);
}

TEST_P(Models, a_wall_beside_keeps_people_off) {
  Scene scene = empty_scene();
  scene.people = {walking_to({0.0, 0.0}, 0.3)};
  const double free = velocity_of(scene.first()).y();
  scene.walls = {{{20.0, 0.26}, {-20.0, 0.26}}};  // walkable to its left, the south
  const double beside = velocity_of(scene.first()).y();
  if (blind()) {
    EXPECT_EQ(beside, free);
  } else {
    EXPECT_LT(beside, free - 0.05);
  }
}

TEST_P(Models, a_wall_that_is_seen_from_behind_is_none) {
  Scene scene = empty_scene();
  scene.people = {walking_to({0.0, 0.0}, 0.3)};
  const Decision free = scene.first();
  scene.walls = {{{-20.0, 0.25}, {20.0, 0.25}}};
  expect_equal(scene.first(), free, 0);
}

/// Least distance [m] of the body to the vehicle on the way to a goal beyond it; below 0: contact.
double least_clearance(const Scene& scene) {
  Walkthrough walk(scene, {Vec2(20.0, 0.0)});
  for (int step = 0; step < 250; ++step) walk.step();
  return walk.least_clearance();
}

/// [m] numerical: the way of a step of 0.1 s at 1.34 m/s. In the crowd, contacts stop whoever would
/// get so deep: gradient navigation pushes over the last 5 cm only, and optimal steps mind where
/// they end and their middle.
constexpr double kTouch = 0.134;

TEST_P(Models, nobody_walks_into_a_vehicle) {
  if (blind()) GTEST_SKIP() << "minds nothing";
  for (const double heading : {0.0, 0.5, kPi / 2.0}) {
    Scene scene = empty_scene();
    scene.people = {walking_to({0.0, 0.0}, 0.0)};
    scene.vehicles = {vehicle({8.0, 0.4}, heading, 0.0)};
    EXPECT_GT(least_clearance(scene), -kTouch) << "parked, heading " << heading;
  }
  for (const double aside : {0.0, 0.5}) {
    Scene scene = empty_scene();
    scene.people = {walking_to({0.0, 0.0}, 0.0)};
    scene.vehicles = {vehicle({20.0, aside}, kPi, 2.0)};
    EXPECT_GT(least_clearance(scene), -kTouch) << "head-on, aside " << aside;
  }
}

TEST_P(Models, a_mirrored_scene_gives_mirrored_velocities) {
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const Scene scene = crowded(seed);
    const double others = share_of_others(scene.decide(), mirrored(scene).decide(),
                                          [](const Vec2& v) { return mirrored(v); });
    EXPECT_LE(others, kRare) << "seed " << seed;
  }
}

TEST_P(Models, a_turned_scene_gives_turned_velocities) {
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const Scene scene = crowded(seed);
    const double angle = 0.7 * seed;
    const double others = share_of_others(scene.decide(), turned(scene, angle).decide(),
                                          [&](const Vec2& v) { return turned(v, angle); });
    EXPECT_LE(others, kRare) << "seed " << seed;
  }
}

TEST_P(Models, the_order_of_people_and_vehicles_does_not_matter_to_the_bit) {
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const Scene scene = crowded(seed);
    const Shuffled other = shuffled(scene, seed);
    const std::vector<Decision> a = scene.decide(), b = other.scene.decide();
    for (std::size_t i = 0; i < b.size(); ++i) expect_equal(b[i], a[other.order[i]], i);
  }
}

TEST_P(Models, neither_threads_nor_ranges_nor_calls_before_matter_to_the_bit) {
  const auto model = make_model(name());
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const Scene scene = crowded(seed);
    const std::vector<Decision> expected = scene.decide();
    const Persons persons = persons_of(scene.people);
    const WallIndex walls(scene.walls);
    model->prepare({&persons, scene.vehicles, &walls, &scene.parameters});
    std::vector<Decision> decisions(scene.people.size());
    std::vector<std::thread> threads;
    constexpr std::size_t kRange = 23;
    for (std::size_t t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t first = t * kRange; first < decisions.size(); first += 4 * kRange) {
          model->decide(first, std::min(first + kRange, decisions.size()), decisions);
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < expected.size(); ++i) expect_equal(decisions[i], expected[i], i);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Models, ::testing::ValuesIn(kModelNames), [](const auto& model) {
  std::string name(model.param);
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace pedzone::test
