// On which edge of its walk SUMO is told that somebody is.
#include "sumo/plan/edges_walked.hpp"

#include <gmock/gmock.h>

#include "four_edges.hpp"

namespace pedzone {
namespace {

class EdgesWalkedTest : public testing::Test, protected test::FourEdges {
 protected:
  EdgesWalked on_all() const { return {network, {e0, e1, e2, e3}, 0, 3}; }
  std::optional<LaneMove> come_to(const EdgesWalked& edges, const Vec2& position) const {
    return edges.come_to(network, position);
  }
};

TEST_F(EdgesWalkedTest, the_next_edge_where_the_person_is) {
  EXPECT_EQ(come_to(on_all(), {30.0, 0.0}), std::nullopt);
  EXPECT_EQ(come_to(on_all(), {60.0, 1.5}), (LaneMove{"e1_0", 10.0, 1.5}));
}

TEST_F(EdgesWalkedTest, not_at_the_very_end_of_an_edge) {
  EXPECT_EQ(come_to(on_all(), {50.4, 0.0}), std::nullopt);
  EXPECT_EQ(come_to(on_all(), {50.6, 0.0}), (LaneMove{"e1_0", 50.6 - 50.0, 0.0}));
  EXPECT_EQ(come_to(on_all(), {99.6, 0.0}), std::nullopt);
}

TEST_F(EdgesWalkedTest, whoever_comes_by_an_edge_is_told_of_the_one_after_it) {
  EXPECT_EQ(come_to(on_all(), {120.0, 0.0}), (LaneMove{"e2_0", 20.0, 0.0}));
}

TEST_F(EdgesWalkedTest, is_looked_at_every_half_second_where_there_is_another) {
  EdgesWalked edges = on_all();
  EXPECT_TRUE(edges.is_due(10.0));
  EXPECT_FALSE(edges.is_due(10.4));
  EXPECT_TRUE(edges.is_due(10.5));
  edges.be_on(network, {"e3_0", 20.0, 0.0});
  EXPECT_FALSE(edges.is_due(20.0));
}

TEST_F(EdgesWalkedTest, never_back) {
  EdgesWalked edges = on_all();
  edges.be_on(network, {"e2_0", 20.0, 0.0});
  EXPECT_EQ(come_to(edges, {60.0, 0.0}), std::nullopt);
  EXPECT_EQ(come_to(edges, {120.0, 0.0}), std::nullopt);
  EXPECT_EQ(come_to(edges, {170.0, 0.0}), (LaneMove{"e3_0", 20.0, 0.0}));
}

TEST_F(EdgesWalkedTest, only_as_far_as_pedzone_walks_it) {
  const EdgesWalked edges(network, {e0, e1, e2, e3}, 1, 2);
  EXPECT_EQ(come_to(edges, {170.0, 0.0}), std::nullopt);
}

TEST_F(EdgesWalkedTest, not_so_far_beside_a_lane_that_sumo_has_it_on_none) {
  EXPECT_TRUE(come_to(on_all(), {60.0, 2.0 + 2.8}));
  EXPECT_EQ(come_to(on_all(), {60.0, 2.0 + 3.0}), std::nullopt);
}

TEST_F(EdgesWalkedTest, not_the_second_passage_of_an_edge) {
  // moveTo would take the first.
  const EdgesWalked edges(network, {e1, e2, e1}, 0, 2);
  EXPECT_EQ(come_to(edges, {120.0, 0.0}), (LaneMove{"e2_0", 20.0, 0.0}));
  EdgesWalked back = edges;
  back.be_on(network, {"e2_0", 20.0, 0.0});
  EXPECT_EQ(come_to(back, {60.0, 0.0}), std::nullopt);
}

TEST_F(EdgesWalkedTest, not_where_the_lane_has_no_such_place) {
  // On the outer side of a corner all places are as near to its tip.
  network.lanes[lane_of(e1)].shape = {{50.0, 0.0}, {75.0, 0.0}, {75.0, 25.0}};
  EXPECT_EQ(come_to(on_all(), {76.0, -1.0}), std::nullopt);
  EXPECT_TRUE(come_to(on_all(), {74.0, 1.0}));
}

}  // namespace
}  // namespace pedzone
