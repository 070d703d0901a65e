// Where it is open which lane a vehicle will take.
#include "sumo/plan/lane_forks.hpp"

#include <gtest/gtest.h>

#include "four_edges.hpp"

namespace pedzone {
namespace {

class LaneForksTest : public testing::Test, protected test::FourEdges {};

TEST_F(LaneForksTest, are_where_one_lane_leads_onto_two_of_an_edge) {
  const int wide = add_edge("wide", "C", "W", 100, 150, 2);
  const int on = add_edge("on", "W", "X", 150, 200, 2);
  connect(lane_of(e1), lane_of(wide));
  for (int k = 0; k < 2; ++k) connect(network.edges[wide].lanes[k], network.edges[on].lanes[k]);
  const std::vector<int> route{e1, wide, on};
  EXPECT_FALSE(LaneForks(network).ahead(route, 0, 1000.0)) << "each lane leads onto one";
  connect(lane_of(e1), network.edges[wide].lanes[1]);
  EXPECT_TRUE(LaneForks(network).ahead(route, 0, 1.0));
  EXPECT_FALSE(LaneForks(network).ahead(route, 1, 1000.0)) << "it is past it";
  EXPECT_FALSE(LaneForks(network).ahead(std::vector<int>{e1, e2, e3}, 0, 1000.0))
      << "not on its way";
}

TEST_F(LaneForksTest, are_looked_for_so_far_ahead) {
  const int wide = add_edge("wide", "D", "W", 150, 200, 2);
  for (const int lane : network.edges[wide].lanes) connect(lane_of(e2), lane);
  const std::vector<int> route{e0, -1, e1, e2, wide};
  EXPECT_TRUE(LaneForks(network).ahead(route, 0, 101.0)) << "two edges of 50 m";
  EXPECT_FALSE(LaneForks(network).ahead(route, 0, 99.0));
}

}  // namespace
}  // namespace pedzone
