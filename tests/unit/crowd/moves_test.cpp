// How far a body may go within a step, whatever velocity it had before.
#include <gtest/gtest.h>

#include "scene.hpp"

namespace pedzone::test {
namespace {

/// [m] gone by somebody who comes at 2 m/s, finds its way free for so far [m], and would stand.
double gone_in_a_step(double free) {
  const Zone zone = zone_of(box(0, 0, 50, 10));
  Scene scene(zone, 1, fixed_model({.free_distance = free}));
  const std::size_t person = scene.add({5.0, 5.0}, {{45.0, 5.0}, {45.0, 5.0}}, 2.0);
  scene.step(0.1);
  return scene.people[person].view.position.x() - 5.0;
}

TEST(Moves, inertia_carries_nobody_farther_than_the_way_is_free) {
  // From 2 m/s, with a relaxation time of 0.5 s, inertia alone carries it by 0.18 m.
  EXPECT_NEAR(gone_in_a_step(10.0), 2.0 * 0.5 * (1.0 - std::exp(-0.2)), 1e-9);
  EXPECT_NEAR(gone_in_a_step(0.05), 0.05, 1e-9);
  EXPECT_NEAR(gone_in_a_step(0.0), 0.0, 1e-9);
}

TEST(Moves, whoever_decides_to_hurry_walks_faster_than_it_prefers) {
  const Zone zone = zone_of(box(0, 0, 50, 10));
  const auto speed_of = [&](double decided) {
    Scene scene(zone, 1, fixed_model({.speed = decided, .free_distance = 10.0}));
    const std::size_t person = scene.add({5.0, 5.0}, {{45.0, 5.0}, {45.0, 5.0}}, 1.2);
    for (int k = 0; k < 60; ++k) scene.step(0.1);
    return scene.people[person].view.velocity.norm();
  };
  EXPECT_NEAR(speed_of(1.2), 1.2, 1e-3);
  EXPECT_NEAR(speed_of(1.44), 1.44, 1e-3);
}

}  // namespace
}  // namespace pedzone::test
