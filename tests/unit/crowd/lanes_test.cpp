// Lanes in a corridor in which people walk both ways (Helbing and Molnár 1995, Fig. 2).
#include <gtest/gtest.h>

#include "two_way_corridor.hpp"

namespace pedzone::test {
namespace {

struct Flow {
  double order = 0.0, by_chance = 0.0, efficiency = 0.0;
};

/// From 90 s to 120 s, mean of as many seeds.
Flow flow_of(CorridorSpec spec, int seeds) {
  Flow mean;
  for (int seed = 1; seed <= seeds; ++seed) {
    spec.seed = static_cast<std::uint64_t>(seed);
    TwoWayCorridor corridor(spec);
    corridor.run(90.0);
    corridor.efficiency();
    for (int k = 0; k < 3; ++k) {
      corridor.run(10.0);
      mean.order += corridor.lane_order() / (3 * seeds);
      mean.by_chance += corridor.lane_order_by_chance() / (3 * seeds);
    }
    mean.efficiency += corridor.efficiency() / seeds;
  }
  return mean;
}

TEST(Lanes, form_among_people_of_the_social_force_model) {
  const Flow flow = flow_of({.model = "social-force"}, 3);
  EXPECT_GT(flow.order, 0.6);
  EXPECT_LT(flow.by_chance, 0.15);
  EXPECT_GT(flow.efficiency, 0.85);
}

// Whoever comes from behind pushes those within its next step to the side, with full weight, since
// the force (and not the person) is beside them. That mixes the lanes.
TEST(Lanes, do_not_form_if_people_mind_who_is_behind_them) {
  const Flow flow = flow_of({.model = "social-force", .field_of_view = 180.0}, 3);
  EXPECT_LT(flow.order, 0.3);
}

}  // namespace
}  // namespace pedzone::test
