// What people come by who keep to the streets of their route.
#include "sumo/plan/route_way.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace pedzone {
namespace {

using testing::IsEmpty;

Ring box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// Four streets of 4 m round a block of 100 m by 60 m.
class RouteWayTest : public testing::Test {
 protected:
  RouteWayTest() {
    left_ = add("left", "A", "B", {0.0, 0.0}, {0.0, 60.0});
    top_ = add("top", "B", "C", {0.0, 60.0}, {100.0, 60.0});
    right_ = add("right", "C", "D", {100.0, 60.0}, {100.0, 0.0});
    bottom_ = add("bottom", "A", "D", {0.0, 0.0}, {100.0, 0.0});
    walk_in({Polygon{box(-2, -2, 102, 62), {box(2, 2, 98, 58)}}});
  }

  int add(const std::string& id, const std::string& from, const std::string& to, const Vec2& begin,
          const Vec2& end) {
    Lane lane;
    lane.id = id + "_0";
    lane.edge = static_cast<int>(network_.edges.size());
    lane.width = 4.0;
    lane.length = (end - begin).norm();
    lane.persons = true;
    lane.shape = {begin, end};
    Edge edge;
    edge.id = id;
    edge.from = from;
    edge.to = to;
    edge.lanes = {static_cast<int>(network_.lanes.size())};
    network_.lanes.push_back(lane);
    network_.edges.push_back(edge);
    zone_.edges.insert(lane.edge);
    return lane.edge;
  }

  void walk_in(const Region& walkable) {
    zone_.walkable = walkable;
    zone_.walls = WallIndex(walkable);
    zone_.ways = WayFinder(walkable, kWayClearance);
  }

  /// From a place on the first edge of the route to one on its last.
  std::vector<Waypoint> waypoints(const std::vector<int>& route, const Vec2& from,
                                  const Vec2& to) const {
    const RoutePart part{network_, zone_, route, 0, static_cast<int>(route.size()) - 1, from, to};
    return waypoints_of(part, ends_of_edges(part));
  }

  Network network_;
  Zone zone_;
  int left_ = 0, top_ = 0, right_ = 0, bottom_ = 0;
};

TEST_F(RouteWayTest, the_middle_of_an_edge_where_another_street_is_as_long) {
  const auto found = waypoints({left_, top_, right_}, {0.0, 29.0}, {100.0, 29.0});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].at.isApprox(Vec2(50.0, 60.0)));
  EXPECT_DOUBLE_EQ(found[0].radius, 3.0);
}

TEST_F(RouteWayTest, also_where_the_other_street_is_a_little_longer) {
  EXPECT_EQ(waypoints({left_, top_, right_}, {0.0, 32.0}, {100.0, 29.0}).size(), 1u);
  EXPECT_THAT(waypoints({left_, top_, right_}, {0.0, 35.0}, {100.0, 32.0}), IsEmpty());
}

TEST_F(RouteWayTest, nothing_where_the_way_leads_along_the_route) {
  EXPECT_THAT(waypoints({left_, bottom_, right_}, {0.0, 25.0}, {100.0, 25.0}), IsEmpty());
}

TEST_F(RouteWayTest, also_where_the_other_street_is_shorter) {
  EXPECT_EQ(waypoints({left_, top_, right_}, {0.0, 12.0}, {100.0, 12.0}).size(), 1u);
}

TEST_F(RouteWayTest, also_of_the_first_and_the_last_edge_where_the_route_has_it) {
  const auto first = waypoints({top_, right_}, {0.0, 57.0}, {100.0, 1.0});
  ASSERT_EQ(first.size(), 1u);
  EXPECT_TRUE(first[0].at.isApprox(Vec2(50.0, 60.0)));
  const auto last = waypoints({right_, top_}, {100.0, 1.0}, {0.0, 57.0});
  ASSERT_EQ(last.size(), 1u);
  EXPECT_TRUE(last[0].at.isApprox(Vec2(100.0, 30.0))) << "from there on it is less far";
  // Not the middle of an edge that the route leaves before it.
  EXPECT_THAT(waypoints({left_, bottom_}, {0.0, 5.0}, {10.0, 0.0}), IsEmpty());
}

TEST_F(RouteWayTest, a_short_cut_that_is_no_street_is_taken) {
  walk_in({Polygon{box(-2, -2, 102, 62), {box(2, 2, 98, 10), box(2, 20, 98, 58)}}});
  EXPECT_THAT(waypoints({left_, top_, right_}, {0.0, 12.0}, {100.0, 12.0}), IsEmpty());
  // No short cut: a way that saves less than a tenth.
  EXPECT_EQ(waypoints({left_, top_, right_}, {0.0, 38.0}, {100.0, 38.0}).size(), 1u);
}

TEST_F(RouteWayTest, open_space_is_crossed) {
  walk_in({Polygon{box(-2, -2, 102, 62), {}}});
  EXPECT_THAT(waypoints({left_, top_, right_}, {0.0, 30.0}, {100.0, 30.0}), IsEmpty());
}

TEST_F(RouteWayTest, whoever_crosses_anywhere_chooses_its_side) {
  zone_.streets.emplace_back();
  EXPECT_THAT(waypoints({left_, top_, right_}, {0.0, 29.0}, {100.0, 29.0}), IsEmpty());
}

TEST_F(RouteWayTest, also_the_next_edge_where_one_could_turn_back) {
  // From the middle of the top street it is 3 m less to go on than to turn back; from where it
  // counts as passed, 3 m before that, it is 3 m more.
  const auto found = waypoints({top_, right_, bottom_}, {2.0, 60.0}, {51.5, 0.0});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].at.isApprox(Vec2(50.0, 60.0)));
  EXPECT_TRUE(found[1].at.isApprox(Vec2(100.0, 30.0)));
}

TEST_F(RouteWayTest, edges_that_only_the_way_to_a_missed_one_misses) {
  // With another block above, the shortest way leads by the right street, but not by the upper one;
  // the shortest way to the middle of that leads by the left street.
  add("above", "C", "E", {100.0, 60.0}, {100.0, 120.0});
  const int beside = add("beside", "B", "F", {0.0, 60.0}, {0.0, 120.0});
  const int upper = add("upper", "F", "E", {0.0, 120.0}, {100.0, 120.0});
  walk_in({Polygon{box(-2, -2, 102, 122), {box(2, 2, 98, 58), box(2, 62, 98, 118)}}});
  const auto found = waypoints({bottom_, right_, top_, beside, upper}, {20.0, 0.0}, {60.0, 120.0});
  const auto is_on_right = [](const Waypoint& one) { return one.at.isApprox(Vec2(100.0, 30.0)); };
  EXPECT_TRUE(std::ranges::any_of(found, is_on_right));
}

}  // namespace
}  // namespace pedzone
