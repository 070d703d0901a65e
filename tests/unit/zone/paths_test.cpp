// Paths found in the zones: in which of them a waypoint lies, its radius, and who can get there.
#include "zone/paths.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "zone/zone.hpp"

namespace pedzone {
namespace {

using ::testing::HasSubstr;

Ring box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

class Paths : public ::testing::Test {
 protected:
  void lane(const Polyline& shape) {
    Lane lane;
    lane.shape = shape;
    network_.lanes.push_back(lane);
  }

  /// With all lanes so far.
  void zone(const std::string& id, const Region& walkable, double radius) {
    Zone zone;
    zone.id = id;
    zone.walkable = walkable;
    zone.walls = WallIndex(walkable);
    zone.ways = WayFinder(walkable, kWayClearance);
    zone.parameters.waypoint_radius = radius;
    for (std::size_t k = 0; k < network_.lanes.size(); ++k)
      zone.lanes.push_back(static_cast<int>(k));
    zones_.push_back(std::move(zone));
  }

  void point(const std::string& id, double x, double y, std::optional<double> radius = {}) {
    network_.waypoints.push_back({id, {x, y}, radius});
  }

  WaypointPath find(std::vector<std::string> waypoints) const {
    return find_paths(network_, zones_, {{"tour", std::move(waypoints), "z.xml", 7}}).at(0);
  }

  std::string error(std::vector<std::string> waypoints) const {
    try {
      find(std::move(waypoints));
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "no error";
  }

  Network network_;
  std::vector<Zone> zones_;
};

TEST_F(Paths, each_zone_has_the_waypoints_that_lie_in_it) {
  lane({{1, 5}, {39, 5}});
  zone("west", repair(box(0, 0, 20, 10)), 1.5);
  zone("east", repair(box(20.5, 0, 40, 10)), 3.0);
  point("a", 5, 5);
  point("b", 30, 5, 0.7);
  point("c", 15, 5, 2.0);
  point("d", 35, 5);
  const WaypointPath path = find({"a", "b", "c", "d", "a"});
  ASSERT_EQ(path.stops.size(), 2u);
  const auto west = path.waypoints(0), east = path.waypoints(1);
  ASSERT_EQ(west.size(), 3u);
  EXPECT_EQ(west[0].at, Vec2(5, 5));
  EXPECT_EQ(west[0].radius, 1.5);
  EXPECT_EQ(west[1].at, Vec2(15, 5));
  EXPECT_EQ(west[1].radius, 2.0);
  EXPECT_EQ(west[2].at, Vec2(5, 5));
  ASSERT_EQ(east.size(), 2u);
  EXPECT_EQ(east[0].radius, 0.7);
  EXPECT_EQ(east[1].radius, 3.0);
}

TEST_F(Paths, unknown_and_outside_are_told) {
  lane({{1, 5}, {19, 5}});
  zone("west", repair(box(0, 0, 20, 10)), 1.0);
  point("a", 5, 5);
  point("out", 25, 5);
  EXPECT_EQ(error({"a", "b"}),
            "z.xml:7: <path id=\"tour\"> attribute waypoints: 'b' is no POI of type "
            "pedzone.waypoint in the scenario's additional files; allowed: a, out");
  EXPECT_THAT(error({"a", "out"}), HasSubstr("'out' lies outside every zone"));
  network_.waypoints.clear();
  EXPECT_THAT(error({"a"}), HasSubstr("allowed: none"));
}

TEST_F(Paths, one_that_no_lane_leads_to_is_told) {
  lane({{1, 5}, {39, 5}});
  zone("z", unite(repair(box(0, 0, 40, 10)), repair(box(10, 20, 20, 30))), 1.0);
  point("street", 5, 5);
  point("yard", 15, 25);
  EXPECT_THAT(error({"street", "yard"}),
              HasSubstr("'yard' cannot be walked to: walls part it from all lanes of its zone"));
  EXPECT_THAT(error({"yard"}), HasSubstr("'yard' cannot be walked to"));
}

TEST_F(Paths, walls_between_all_others_and_one_are_told) {
  lane({{1, 5}, {18, 5}});
  lane({{22, 5}, {39, 5}});
  zone("z", unite(repair(box(0, 0, 20, 10)), repair(box(21, 0, 40, 10))), 1.0);
  point("a", 5, 5);
  point("b", 15, 5);
  point("c", 30, 5);
  EXPECT_EQ(find({"a", "b"}).stops[0].size(), 2u);
  EXPECT_EQ(find({"c"}).stops[0].size(), 1u);
  EXPECT_THAT(error({"a", "b", "c"}),
              HasSubstr("'c' cannot be walked to: walls part it from the other waypoints"));
}

}  // namespace
}  // namespace pedzone
