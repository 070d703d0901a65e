// To which side somebody who stands makes way for who is held up by it.
#include <gtest/gtest.h>

#include "scene.hpp"

namespace pedzone::test {
namespace {

/// [m] by which one that stands so far [m] left of the line of somebody who walks in `direction`
/// [rad], and cannot get on, has stepped to the left after some seconds.
double stepped_left(double lateral, double direction) {
  const Zone zone = zone_of(box(0, 0, 20, 20));
  Scene scene(zone, 1, fixed_model({.direction = direction}));
  const Vec2 here(10.0, 10.0), along = unit(direction);
  const Vec2 goal = here + along * 8.0;
  scene.add(here, {goal, goal}, 1.2);
  SeenPerson stander;
  stander.position = here + along * 0.6 + left_of(along) * lateral;
  stander.key = 7;
  scene.crowd.see(std::vector<SeenPerson>{stander});
  for (int k = 0; k < 50; ++k) scene.step(0.1);
  return (scene.crowd.seen_at(7).value() - stander.position).dot(left_of(along));
}

TEST(MakingWay, whoever_stands_steps_to_the_side_on_which_it_stands) {
  for (double direction = -3.0; direction <= 3.0; direction += 1.0) {
    EXPECT_GT(stepped_left(0.1, direction), 0.1) << direction;
    EXPECT_LT(stepped_left(-0.1, direction), -0.1) << direction;
  }
}

TEST(MakingWay, goes_no_farther_the_farther_aside_it_stands_already) {
  EXPECT_GT(stepped_left(0.05, 0.0), stepped_left(0.2, 0.0));
  EXPECT_EQ(stepped_left(1.5, 0.0), 0.0);
}

}  // namespace
}  // namespace pedzone::test
