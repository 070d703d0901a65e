// Plans of stretches on a small street: e0 - e1 - e2 - e3 in a row, e1 and e2 in the zone.
#include "sumo/live/zone_route.hpp"

#include <gmock/gmock.h>

namespace pedzone {
namespace {

class ZoneRouteTest : public testing::Test {
 protected:
  /// Adds an edge with one lane from x = begin to x = end.
  int add_edge(const std::string& id, const std::string& from, const std::string& to, double begin,
               double end, int lanes = 1) {
    const int edge = static_cast<int>(network_.edges.size());
    Edge added;
    added.id = id;
    added.from = from;
    added.to = to;
    for (int i = 0; i < lanes; ++i) {
      Lane lane;
      lane.id = id + "_" + std::to_string(i);
      lane.edge = edge;
      lane.width = 4.0;
      lane.length = std::abs(end - begin);
      lane.persons = i == 0;
      lane.vehicles = true;
      lane.shape = {{begin, 4.0 * i}, {end, 4.0 * i}};
      added.lanes.push_back(static_cast<int>(network_.lanes.size()));
      network_.lanes.push_back(lane);
    }
    network_.edges.push_back(added);
    network_.edge_index[id] = edge;
    return edge;
  }

  void SetUp() override {
    e0_ = add_edge("e0", "A", "B", 0, 50);
    e1_ = add_edge("e1", "B", "C", 50, 100);
    e2_ = add_edge("e2", "C", "D", 100, 150);
    e3_ = add_edge("e3", "D", "E", 150, 200);
    zone_.edges = {e1_, e2_};
    link(e1_, e2_);
  }

  void link(int a, int b) { zone_.links.insert({std::min(a, b), std::max(a, b)}); }

  Network network_;
  Zone zone_;
  int e0_ = 0, e1_ = 0, e2_ = 0, e3_ = 0;
};

TEST_F(ZoneRouteTest, walks_to_the_end_of_the_last_edge_in_the_zone) {
  const auto stretch = plan_stretch(network_, zone_, {e0_, e1_, e2_, e3_}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kLeave);
  EXPECT_EQ(stretch->last, 2);
  EXPECT_TRUE(stretch->forward);
  EXPECT_EQ(network_.lanes[stretch->lane].id, "e2_0");
  EXPECT_EQ(network_.lanes[stretch->hop_lane].id, "e3_0");
  EXPECT_DOUBLE_EQ(stretch->position, 50.0 - kPortalInset);
}

TEST_F(ZoneRouteTest, ends_where_the_zone_does_not_link_two_edges) {
  zone_.links.clear();  // a signalled crossing between e1 and e2
  const auto stretch = plan_stretch(network_, zone_, {e0_, e1_, e2_, e3_}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->last, 1);
  EXPECT_EQ(network_.lanes[stretch->hop_lane].id, "e2_0");
}

TEST_F(ZoneRouteTest, portal_is_as_wide_as_the_lane) {
  const auto stretch = plan_stretch(network_, zone_, {e0_, e1_, e2_, e3_}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_NEAR((stretch->destination.a - stretch->destination.b).norm(), 4.0, 1e-9);
  EXPECT_NEAR(stretch->destination.a.x(), 150.0 - kPortalInset, 1e-9);
}

TEST_F(ZoneRouteTest, leaves_at_the_beginning_when_walking_against_the_edge) {
  const auto stretch = plan_stretch(network_, zone_, {e3_, e2_, e1_, e0_}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_FALSE(stretch->forward);
  EXPECT_EQ(network_.lanes[stretch->lane].id, "e1_0");
  EXPECT_DOUBLE_EQ(stretch->position, kPortalInset);
}

TEST_F(ZoneRouteTest, arrives_at_the_arrival_position_inside) {
  const auto stretch = plan_stretch(network_, zone_, {e0_, e1_, e2_}, 1, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kArrive);
  EXPECT_DOUBLE_EQ(stretch->position, 20.0);
  EXPECT_EQ(network_.lanes[stretch->hop_lane].id, "e1_0");
}

TEST_F(ZoneRouteTest, removes_the_stage_when_one_edge_with_one_lane_is_all) {
  const auto stretch = plan_stretch(network_, zone_, {e1_}, 0, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kRemoveStage);
}

TEST_F(ZoneRouteTest, hops_over_another_lane_when_one_edge_is_all) {
  const int wide = add_edge("wide", "X", "Y", 0, 50, 2);
  zone_.edges.insert(wide);
  const auto stretch = plan_stretch(network_, zone_, {wide}, 0, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kArrive);
  EXPECT_EQ(network_.lanes[stretch->hop_lane].id, "wide_1");
}

TEST_F(ZoneRouteTest, never_releases_on_a_short_edge) {
  const int brief = add_edge("brief", "D", "E", 150, 150.2);
  const int after = add_edge("after", "E", "F", 150.2, 200);
  zone_.edges.insert(brief);
  link(e2_, brief);
  const auto stretch = plan_stretch(network_, zone_, {e1_, e2_, brief, after}, 0, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->last, 1) << "released on e2, before the short edge";
  EXPECT_EQ(network_.lanes[stretch->hop_lane].id, "brief_0");
}

TEST_F(ZoneRouteTest, steps_over_the_last_junction_where_the_zone_ends_with_a_short_edge) {
  const int stub = add_edge("stub", "D", "F", 150, 151);
  const int path = add_edge("path", "F", "G", 152, 190);
  const int beyond = add_edge("beyond", "G", "H", 190, 230);
  const int area = add_edge(":F_w0", "", "", 151, 152);
  network_.edges[area].function = EdgeFunction::kWalkingArea;
  const auto lane = [&](int edge) { return network_.edges[edge].lanes[0]; };
  network_.connections.push_back({lane(stub), lane(area)});
  zone_.edges.insert(stub);
  link(e2_, stub);
  zone_.walls = WallIndex(Region{Polygon{{{50, -2}, {152, -2}, {152, 2}, {50, 2}}, {}}});
  const std::vector<int> route{e1_, e2_, stub, path, beyond};
  // Not where other than a single walking area lies between: SUMO walks the person across that.
  EXPECT_EQ(plan_stretch(network_, zone_, route, 0, 20.0)->release, Release::kLeave);
  network_.connections.push_back({lane(area), lane(path)});
  const auto stretch = plan_stretch(network_, zone_, route, 0, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->release, Release::kStepOver);
  EXPECT_EQ(stretch->last, 2);
  EXPECT_EQ(network_.lanes[stretch->lane].id, "path_0");
  EXPECT_EQ(network_.lanes[stretch->hop_lane].id, "e1_0");
  EXPECT_DOUBLE_EQ(stretch->position, kPortalInset);
  EXPECT_LE(stretch->destination.a.x(), 152.0);
  EXPECT_GT(stretch->destination.a.x(), 151.0);
  // Where the walk ends on that edge SUMO would guess the direction.
  EXPECT_EQ(plan_stretch(network_, zone_, {e1_, e2_, stub, path}, 0, 20.0)->release,
            Release::kLeave);
}

TEST_F(ZoneRouteTest, is_not_planned_on_a_short_edge_alone) {
  const int brief = add_edge("brief", "C", "D", 100, 100.2);
  Zone zone;
  zone.edges = {brief};
  EXPECT_FALSE(plan_stretch(network_, zone, {e1_, brief, e3_}, 1, 20.0));
}

TEST_F(ZoneRouteTest, releases_only_where_the_route_comes_for_the_first_time) {
  // e2 comes twice: moveTo would put the person on its first passage.
  const int loop = add_edge("loop", "D", "C", 150, 100);
  link(e2_, loop);
  link(loop, e1_);
  const auto stretch = plan_stretch(network_, zone_, {e0_, e2_, loop, e1_, e2_, e3_}, 3, 20.0);
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->last, 3);
  EXPECT_EQ(network_.lanes[stretch->lane].id, "e1_0");
}

TEST_F(ZoneRouteTest, does_not_guess_the_end_where_two_edges_meet_twice) {
  const int twin = add_edge("twin", "C", "D", 100, 150);
  Zone zone;
  zone.edges = {e2_};
  // From D into e2 and out at C onto its twin: SUMO would deduce forward.
  EXPECT_FALSE(plan_stretch(network_, zone, {e3_, e2_, twin}, 1, 20.0));
}

}  // namespace
}  // namespace pedzone
