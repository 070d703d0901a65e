// People of the optimal steps model walk in discrete steps, and slower the denser they are (Seitz
// and Köster 2012).
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "model/optimal_steps.hpp"
#include "two_way_corridor.hpp"

namespace pedzone::test {
namespace {

constexpr double kStep = 0.1;  // [s]

TEST(Steps, turn_people_only_where_one_ends) {
  Zone zone = zone_of(box(0, 0, 210, 20), {}, true);
  zone.model = "optimal-steps";
  Scene scene(zone);
  scene.add({2, 8}, line_at_x(208, 0, 20));
  scene.add({2, 12}, line_at_x(208, 0, 20));
  std::vector<int> turns(2);
  std::set<double> together;
  for (int k = 0; k < 1000; ++k) {
    const Vec2 before[] = {scene.people[0].view.velocity, scene.people[1].view.velocity};
    scene.step(kStep);
    int turned = 0;
    for (std::size_t p = 0; p < 2; ++p) {
      const bool turns_now = (scene.people[p].view.velocity - before[p]).norm() > 1e-9;
      turns[p] += turns_now;
      turned += turns_now;
    }
    if (turned == 2) together.insert(scene.time);
  }
  const double steps = 1000 * kStep / (optimal_steps::step_length(1.34) / 1.34);
  for (const int count : turns) EXPECT_NEAR(count, steps, 0.1 * steps);
  EXPECT_LT(together.size(), 0.5 * steps);  // each has its own time
}

TEST(Steps, get_slower_with_density) {
  double before = 1.1;
  for (const int people : {10, 40, 80}) {  // 0.5, 2 and 4 /m²
    TwoWayCorridor corridor({.model = "optimal-steps",
                             .length = 10.0,
                             .width = 4.0,
                             .each_way = people,
                             .both_ways = false});
    corridor.run(15.0);
    corridor.efficiency();
    corridor.run(15.0);
    const double speed = corridor.efficiency();
    EXPECT_LT(speed, before - 0.05) << people;
    before = speed;
  }
}

TEST(Steps, keep_the_preferred_speed_of_somebody_alone) {
  Zone zone = zone_of(box(0, 0, 110, 10), {}, true);
  zone.model = "optimal-steps";
  Scene scene(zone);
  const auto person = scene.add({2, 5}, line_at_x(108, 0, 10));
  scene.run(120);
  ASSERT_EQ(scene.arrived(), 1u);
  const auto& p = scene.people[person];
  EXPECT_NEAR((p.path.back().x() - 2.0) / p.arrival_time, 1.34, 0.02 * 1.34);
}

}  // namespace
}  // namespace pedzone::test
