// Nobody is faster after a step than its free distance allowed: it would go on too fast.
#include <gtest/gtest.h>

#include "scene.hpp"

namespace pedzone::test {
namespace {

/// [m/s] after a step of `dt` [s] of somebody who comes at 2 m/s, finds its way free for so far
/// [m], and would stand.
double speed_after_a_step(double free, double dt) {
  const Zone zone = zone_of(box(0, 0, 50, 10));
  Scene scene(zone, 1, fixed_model({.free_distance = free}));
  const std::size_t person = scene.add({5.0, 5.0}, {{45.0, 5.0}, {45.0, 5.0}}, 2.0);
  scene.step(dt);
  return scene.people[person].view.velocity.x();
}

TEST(Overshoot, nobody_is_left_faster_than_its_way_was_free) {
  EXPECT_NEAR(speed_after_a_step(0.05, 0.1), 0.05 / 0.1, 1e-9);
  EXPECT_NEAR(speed_after_a_step(0.0, 0.1), 0.0, 1e-9);
  // With a relaxation time of 0.5 s, from 2 m/s.
  EXPECT_NEAR(speed_after_a_step(10.0, 0.1), 2.0 * std::exp(-0.2), 1e-9);
}

}  // namespace
}  // namespace pedzone::test
