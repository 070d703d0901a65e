// How far a body may go within a step, whatever velocity it had before.
#include <gtest/gtest.h>

#include "scene.hpp"

namespace pedzone::test {
namespace {

/// Finds the way ahead free for so far and no farther, and stops there.
class StopsSoon : public WalkingModel {
 public:
  explicit StopsSoon(double free) : free_(free) {}
  void prepare(const Snapshot&) override {}
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override {
    for (std::size_t i = first; i < last; ++i) {
      decisions[i] = {};
      decisions[i].free_distance = free_;
    }
  }

 private:
  double free_;  ///< [m]
};

double gone_in_a_step(double free) {
  const Zone zone = zone_of(box(0, 0, 50, 10));
  Scene scene(zone, 1, std::make_unique<StopsSoon>(free));
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

}  // namespace
}  // namespace pedzone::test
