// Plans of stretches on a small street: e0 - e1 - e2 - e3 in a row, e1 and e2 in the zone.
#include "sumo/plan/zone_route.hpp"

#include <gmock/gmock.h>

#include "four_edges.hpp"

namespace pedzone {
namespace {

class ZoneRouteTest : public testing::Test, protected test::FourEdges {};

TEST_F(ZoneRouteTest, walks_to_the_end_of_the_last_edge_in_the_zone) {
  const auto stretch = plan_stretch(network, zone, {e0, e1, e2, e3}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kLeave);
  EXPECT_EQ(stretch->last, 2);
  EXPECT_TRUE(stretch->forward);
  EXPECT_EQ(network.lanes[stretch->lane].id, "e2_0");
  EXPECT_EQ(network.lanes[stretch->hop_lane].id, "e3_0");
  EXPECT_DOUBLE_EQ(stretch->position, 50.0 - kPortalInset);
}

TEST_F(ZoneRouteTest, ends_where_the_zone_does_not_link_two_edges) {
  zone.links.clear();  // a signalled crossing between e1 and e2
  const auto stretch = plan_stretch(network, zone, {e0, e1, e2, e3}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->last, 1);
  EXPECT_EQ(network.lanes[stretch->hop_lane].id, "e2_0");
}

TEST_F(ZoneRouteTest, ends_where_the_other_side_of_a_street_is_linked_at_its_other_end_only) {
  const Edge street = network.edges[e2];
  const int back = add_edge("back", street.to, street.from, 150.0, 100.0);
  zone.edges.insert(back);
  const auto last = [&](const std::vector<int>& route, int first) {
    return plan_stretch(network, zone, route, first, 20.0)->last;
  };
  auto& at = zone.links[{std::min(e2, back), std::max(e2, back)}];
  at = {street.from};
  EXPECT_EQ(last({e0, e1, e2, back}, 1), 2) << "SUMO's cross at its end";
  at = {street.to};
  EXPECT_EQ(last({e0, e1, e2, back}, 1), 3);
  const std::vector<int> begins{e2, back};
  EXPECT_FALSE(plan_stretch(network, zone, begins, 0, 20.0)) << "who knows where SUMO's cross";
  at = {street.from, street.to};
  EXPECT_EQ(last(begins, 0), 1);
}

TEST_F(ZoneRouteTest, portal_is_as_wide_as_a_lane_for_people) {
  network.lanes[lane_of(e2)].vehicles = false;
  const auto stretch = plan_stretch(network, zone, {e0, e1, e2, e3}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_NEAR((stretch->destination.a - stretch->destination.b).norm(), 4.0, 1e-9);
  EXPECT_NEAR(stretch->destination.a.x(), 150.0 - kPortalInset, 1e-9);
}

TEST_F(ZoneRouteTest, portal_is_at_the_side_of_a_lane_that_vehicles_use_as_well) {
  for (const bool left_hand : {false, true}) {
    network.left_hand = left_hand;
    const auto stretch = plan_stretch(network, zone, {e0, e1, e2, e3}, 1, 20.0);
    ASSERT_TRUE(stretch);
    const double side = left_hand ? 2.0 : -2.0;
    EXPECT_NEAR(stretch->destination.a.y(), side, 1e-9);
    EXPECT_NEAR(stretch->destination.b.y(), 0.5 * side, 1e-9);
  }
}

TEST_F(ZoneRouteTest, leaves_at_the_beginning_when_walking_against_the_edge) {
  const auto stretch = plan_stretch(network, zone, {e3, e2, e1, e0}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_FALSE(stretch->forward);
  EXPECT_EQ(network.lanes[stretch->lane].id, "e1_0");
  EXPECT_DOUBLE_EQ(stretch->position, kPortalInset);
}

TEST_F(ZoneRouteTest, arrives_at_the_arrival_position_inside) {
  const auto stretch = plan_stretch(network, zone, {e0, e1, e2}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kArrive);
  EXPECT_DOUBLE_EQ(stretch->position, 20.0);
  EXPECT_EQ(network.lanes[stretch->hop_lane].id, "e1_0");
}

TEST_F(ZoneRouteTest, removes_the_stage_when_one_edge_with_one_lane_is_all) {
  const auto stretch = plan_stretch(network, zone, {e1}, 0, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kRemoveStage);
}

TEST_F(ZoneRouteTest, hops_over_another_lane_when_one_edge_is_all) {
  const int wide = add_edge("wide", "X", "Y", 0, 50, 2);
  zone.edges.insert(wide);
  const auto stretch = plan_stretch(network, zone, {wide}, 0, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kArrive);
  EXPECT_EQ(network.lanes[stretch->hop_lane].id, "wide_1");
}

TEST_F(ZoneRouteTest, never_releases_on_a_short_edge) {
  const int brief = add_edge("brief", "D", "E", 150, 150.2);
  const int after = add_edge("after", "E", "F", 150.2, 200);
  zone.edges.insert(brief);
  link(e2, brief);
  const auto stretch = plan_stretch(network, zone, {e1, e2, brief, after}, 0, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->last, 1) << "released on e2, before the short edge";
  EXPECT_EQ(network.lanes[stretch->hop_lane].id, "brief_0");
}

TEST_F(ZoneRouteTest, steps_over_the_last_junction_where_the_zone_ends_with_a_short_edge) {
  const int stub = add_edge("stub", "D", "F", 150, 151);
  const int path = add_edge("path", "F", "G", 152, 190);
  const int beyond = add_edge("beyond", "G", "H", 190, 230);
  const int area = add_edge(":F_w0", "", "", 151, 152);
  network.edges[area].function = EdgeFunction::kWalkingArea;
  const auto lane = [&](int edge) { return network.edges[edge].lanes[0]; };
  network.connections.push_back({lane(stub), lane(area)});
  zone.edges.insert(stub);
  link(e2, stub);
  zone.walls = WallIndex(Region{Polygon{{{50, -2}, {152, -2}, {152, 2}, {50, 2}}, {}}});
  const std::vector<int> route{e1, e2, stub, path, beyond};
  // Not where other than a single walking area lies between: SUMO walks the person across that.
  EXPECT_EQ(plan_stretch(network, zone, route, 0, 20.0)->release, Release::kLeave);
  network.connections.push_back({lane(area), lane(path)});
  const auto stretch = plan_stretch(network, zone, route, 0, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kStepOver);
  EXPECT_EQ(stretch->last, 2);
  EXPECT_EQ(network.lanes[stretch->lane].id, "path_0");
  EXPECT_EQ(network.lanes[stretch->hop_lane].id, "e1_0");
  EXPECT_DOUBLE_EQ(stretch->position, kEntryInset);
  EXPECT_LE(stretch->destination.a.x(), 152.0);
  EXPECT_GT(stretch->destination.a.x(), 151.0);
  // Where the walk ends on that edge SUMO would guess the direction.
  EXPECT_EQ(plan_stretch(network, zone, {e1, e2, stub, path}, 0, 20.0)->release, Release::kLeave);
}

class StepOver : public ZoneRouteTest {
 protected:
  Release release() const {
    return plan_stretch(network, zone, {e0, e1, e2, e3, e4_}, 1, 20.0)->release;
  }

  const int e4_ = add_walking_area();
};

TEST_F(StepOver, across_a_junction_of_the_zone) {
  const auto stretch = plan_stretch(network, zone, {e0, e1, e2, e3, e4_}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kStepOver);
  EXPECT_EQ(stretch->last, 2);
  EXPECT_EQ(network.lanes[stretch->lane].id, "e3_0");
  EXPECT_EQ(network.lanes[stretch->hop_lane].id, "e1_0");
  EXPECT_DOUBLE_EQ(stretch->position, kEntryInset);
  const Destination& there = stretch->destination;
  EXPECT_NEAR(there.a.x(), 152.0 - kWayClearance, 0.01);
  EXPECT_GT(std::abs(there.a.y() - there.b.y()), 3.0) << "as wide as the lane";
}

TEST_F(StepOver, by_way_of_the_last_edge_where_that_is_all) {
  const auto stretch = plan_stretch(network, zone, {e0, e1, e2, e3, e4_}, 2, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kStepOver);
  EXPECT_EQ(network.lanes[stretch->hop_lane].id, "e2_0");
}

TEST_F(StepOver, not_where_the_junction_is_not_the_zones) {
  has_space({{50, -2}, {150.5, -2}, {150.5, 2}, {50, 2}});
  EXPECT_EQ(release(), Release::kLeave);
}

TEST_F(StepOver, not_where_only_a_long_way_leads_there) {
  has_space({{50, -2},
             {150, -2},
             {150, 20},
             {151, 20},
             {151, -2},
             {152, -2},
             {152, 22},
             {149, 22},
             {149, 2},
             {50, 2}});
  EXPECT_EQ(release(), Release::kLeave);
}

TEST_F(StepOver, not_where_other_than_a_walking_area_lies_between) {
  network.connections.pop_back();
  EXPECT_EQ(release(), Release::kLeave);
}

TEST_F(ZoneRouteTest, is_not_planned_on_a_short_edge_alone) {
  const int brief = add_edge("brief", "C", "D", 100, 100.2);
  Zone only;
  only.edges = {brief};
  EXPECT_FALSE(plan_stretch(network, only, {e1, brief, e3}, 1, 20.0));
}

TEST_F(ZoneRouteTest, releases_only_where_the_route_comes_for_the_first_time) {
  // e2 comes twice: moveTo would put the person on its first passage.
  const int loop = add_edge("loop", "D", "C", 150, 100);
  link(e2, loop);
  link(loop, e1);
  const auto stretch = plan_stretch(network, zone, {e0, e2, loop, e1, e2, e3}, 3, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->last, 3);
  EXPECT_EQ(network.lanes[stretch->lane].id, "e1_0");
}

TEST_F(ZoneRouteTest, does_not_guess_the_end_where_two_edges_meet_twice) {
  const int twin = add_edge("twin", "C", "D", 100, 150);
  Zone only;
  only.edges = {e2};
  // From D into e2 and out at C onto its twin: SUMO would deduce forward.
  EXPECT_FALSE(plan_stretch(network, only, {e3, e2, twin}, 1, 20.0));
}

}  // namespace
}  // namespace pedzone
