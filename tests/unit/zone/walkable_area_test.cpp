// The walkable area: lanes, obstacles cut open, open space, polygons, levels.
#include <gmock/gmock.h>

#include "scene.hpp"

namespace pedzone::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Polyline kStreet{{0, 0}, {60, 0}};

/// Every metre of a lane's centre line is walkable.
void expect_centre_line_walkable(const Network& network, const Zone& zone, int lane) {
  const Polyline& shape = network.lanes[lane].shape;
  for (std::size_t i = 0; i + 1 < shape.size(); ++i) {
    const Vec2 piece = shape[i + 1] - shape[i];
    for (double along = 0.1; along < piece.norm() - 0.1; along += 1.0) {
      const Vec2 place = shape[i] + piece.normalized() * along;
      EXPECT_TRUE(contains(zone.walkable, place)) << network.lanes[lane].id << " " << along;
    }
  }
}

TEST(WalkableArea, is_the_lane_where_nothing_else_is) {
  Scene scene;
  scene.add({"street", kStreet});
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_NEAR(area(zone.walkable), 120.0, 1e-3);
  EXPECT_THAT(zone.warnings, IsEmpty());
}

TEST(WalkableArea, an_obstacle_beside_the_centre_line_takes_its_share_of_the_lane) {
  Scene scene;
  scene.add({"street", kStreet}).add_building("house", rectangle(20, 0.4, 30, 9));
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_NEAR(area(zone.walkable), 120.0 - 10 * 0.6, 0.1);
  EXPECT_THAT(zone.warnings, IsEmpty());
}

TEST(WalkableArea, an_obstacle_across_the_lane_is_cut_open_with_a_warning_that_names_both) {
  for (const std::string type : {"building", "jupedsim.obstacle", "pedzone.obstacle"}) {
    Scene scene;
    scene.add({"street", kStreet}).add_polygon("gate", type, rectangle(20, -10, 30, 10));
    const Zone zone = scene.zone();
    expect_centre_line_walkable(scene.network(), zone, 0);
    EXPECT_TRUE(contains(zone.walkable, {25, 0.9})) << "as wide as the lane";
    EXPECT_FALSE(contains(zone.walkable, {25, 1.2}));
    EXPECT_LT(zone.ways.distance({5, 0}, {55, 0}), 50.5);
    EXPECT_THAT(zone.warnings, ElementsAre("polygon 'gate' cuts the centre line of lane "
                                           "'street_0': cut open along it"));
    EXPECT_NEAR(area(zone.obstacles), 10 * 18, 0.1);
  }
}

TEST(WalkableArea, other_polygons_block_nobody) {
  Scene scene;
  scene.add({"street", kStreet}).add_polygon("lot", "parking", rectangle(20, -10, 30, 10));
  EXPECT_NEAR(area(scene.zone({closed_spec()}).walkable), 120.0, 1e-3);
}

TEST(WalkableArea, an_obstacle_at_the_end_of_a_lane_is_cut_open_too) {
  Scene scene;
  scene.add({"street", kStreet}).add_building("house", rectangle(59.8, -10, 80, 10));
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_TRUE(contains(zone.walkable, {59.9, 0.5}));
  EXPECT_EQ(zone.warnings.size(), 1u);
}

TEST(WalkableArea, houses_that_together_leave_no_room_are_cut_open) {
  Scene scene;
  scene.add({"street", kStreet})
      .add_building("north", rectangle(20, 0.1, 30, 9))
      .add_building("south", rectangle(20, -9, 30, -0.1));
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_LT(zone.ways.distance({5, 0}, {55, 0}), 50.5);
  EXPECT_THAT(zone.warnings, ElementsAre(HasSubstr("'north' leaves no way through on lane"),
                                         HasSubstr("'south' leaves no way through on lane")));
}

TEST(WalkableArea, a_fountain_on_a_wide_square_stays) {
  Scene scene;
  Street square{"square", kStreet};
  square.width = 40;
  scene.add(square).add_polygon("fountain", "pedzone.obstacle", rectangle(28, -2, 32, 2));
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_FALSE(contains(zone.walkable, {30, 0}));
  EXPECT_NEAR(area(zone.walkable), 60 * 40 - 16, 0.1);
  EXPECT_THAT(zone.warnings, IsEmpty());
  const double way = zone.ways.distance({5, 0}, {55, 0});
  EXPECT_GT(way, 50.1);
  EXPECT_LT(way, 52.0);
}

TEST(WalkableArea, self_crossing_polygons_are_repaired_with_a_warning) {
  Scene scene;
  scene.add({"street", kStreet}).add_building("bow", {{20, 2}, {30, 8}, {30, 2}, {20, 8}});
  const Zone zone = scene.zone();
  EXPECT_THAT(zone.warnings, ElementsAre("polygon 'bow' crosses itself: repaired"));
  EXPECT_FALSE(contains(zone.walkable, {21, 5}));
  EXPECT_TRUE(contains(zone.walkable, {25, 2.5}));
}

TEST(WalkableArea, polygons_without_an_area_are_left_out_with_a_warning) {
  Scene scene;
  scene.add({"street", kStreet})
      .add_building("nothing", {})
      .add_building("point", {{20, 0}})
      .add_building("line", {{20, -5}, {20, 5}})
      .add_building("fold", {{20, -5}, {20, 5}, {20, -5}})
      .add_building("sliver", {{20, -5}, {20, 5}, {20.0005, 0}});
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_NEAR(area(zone.walkable), 120.0, 1e-3);
  EXPECT_EQ(zone.warnings.size(), 4u);  // the empty one is nowhere near
  for (const std::string& warning : zone.warnings) {
    EXPECT_THAT(warning, HasSubstr("has no area: left out"));
  }
}

TEST(WalkableArea, walkable_polygons_are_joined_and_obstacles_taken_from_them) {
  for (const std::string type : {"jupedsim.walkable_area", "pedzone.walkable"}) {
    Scene scene;
    scene.add({"street", kStreet})
        .add_polygon("market", type, rectangle(20, 0, 40, 30))
        .add_building("hall", rectangle(25, 20, 30, 25));
    EXPECT_NEAR(area(scene.zone({closed_spec()}).walkable), 120 + 20 * 29 - 25, 0.1) << type;
  }
}

TEST(WalkableArea, a_named_polygon_is_walkable_whatever_its_type) {
  Scene scene;
  scene.add({"street", kStreet}).add_polygon("market", "landuse", rectangle(20, 0, 40, 30));
  ZoneSpec spec = closed_spec();
  EXPECT_NEAR(area(scene.zone({spec}).walkable), 120, 0.1);
  spec.polygons = {"market"};
  EXPECT_NEAR(area(scene.zone({spec}).walkable), 120 + 20 * 29, 0.1);
}

TEST(WalkableArea, a_named_polygon_that_crosses_itself_or_has_no_area_is_an_error) {
  Scene scene;
  scene.add({"street", kStreet})
      .add_polygon("bow", "landuse", {{20, 2}, {30, 8}, {30, 2}, {20, 8}})
      .add_polygon("line", "landuse", {{20, 2}, {30, 8}});
  ZoneSpec spec;
  spec.id = "z";
  spec.file = "z.xml";
  spec.line = 2;
  spec.polygons = {"bow"};
  EXPECT_THAT(complaint(scene.network(), {spec}),
              HasSubstr("z.xml:2: <zone id=\"z\"> attribute polygons: 'bow' crosses itself"));
  spec.polygons = {"line"};
  EXPECT_THAT(complaint(scene.network(), {spec}), HasSubstr("'line' has no area"));
}

TEST(WalkableArea, islands_without_a_lane_are_dropped_with_a_warning) {
  Scene scene;
  scene.add({"street", kStreet}).add_polygon("isle", "pedzone.walkable", rectangle(20, 50, 40, 70));
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_NEAR(area(zone.walkable), 120, 0.1);
  EXPECT_THAT(zone.warnings,
              ElementsAre("walkable polygon 'isle' touches no lane of the zone: left out"));
}

TEST(OpenSpace, reaches_12_metres_from_pedestrian_streets_by_default) {
  Scene scene;
  scene.add({"street", kStreet});
  const Zone zone = scene.zone();
  EXPECT_TRUE(contains(zone.walkable, {30, 12.9}));  // half the lane's width and 12 m
  EXPECT_FALSE(contains(zone.walkable, {30, 13.1}));
}

TEST(OpenSpace, is_off_by_default_elsewhere_and_on_for_all_lanes_where_the_zone_says_so) {
  Street living{"living", kStreet, "highway.living_street"};
  living.vehicles = true;
  Scene scene;
  scene.add(living);
  EXPECT_NEAR(area(scene.zone().walkable), 120, 0.1);
  ZoneSpec spec;
  spec.open_space = 5.0;
  EXPECT_TRUE(contains(scene.zone({spec}).walkable, {30, 5.9}));
  EXPECT_FALSE(contains(scene.zone({spec}).walkable, {30, 6.1}));
}

TEST(OpenSpace, ends_at_a_closed_row_of_houses) {
  Scene scene;
  scene.add({"street", kStreet}).add_building("row", rectangle(-30, 4, 90, 6));
  const Zone zone = scene.zone();
  EXPECT_TRUE(contains(zone.walkable, {30, 3.9}));
  EXPECT_FALSE(contains(zone.walkable, {30, 6.5}));
  EXPECT_TRUE(contains(zone.walkable, {30, -12.9}));
}

TEST(OpenSpace, leads_through_gaps_that_a_body_passes_only) {
  for (const auto& [gap, passes] : {std::pair{0.3, false}, {1.0, true}}) {
    Scene scene;
    scene.add({"street", kStreet})
        .add_building("west", rectangle(-30, 4, 30 - gap / 2, 6))
        .add_building("east", rectangle(30 + gap / 2, 4, 90, 6));
    EXPECT_EQ(contains(scene.zone().walkable, {10, 8}), passes) << gap;
  }
}

TEST(OpenSpace, does_not_lead_over_a_road_that_stays_sumos) {
  Scene scene;
  scene.add({"street", kStreet}).add_road("road", {{-40, 7}, {100, 7}}, 4.0);
  const Zone zone = scene.zone();
  EXPECT_TRUE(contains(zone.walkable, {30, 4.9}));
  EXPECT_FALSE(contains(zone.walkable, {30, 7}));
  EXPECT_FALSE(contains(zone.walkable, {30, 10}));
}

TEST(OpenSpace, a_road_does_not_cut_the_lane_it_crosses) {
  Scene scene;
  scene.add({"street", kStreet}).add_road("road", {{30, -40}, {30, 40}}, 4.0);
  const Zone zone = scene.zone();
  expect_centre_line_walkable(scene.network(), zone, 0);
  EXPECT_FALSE(contains(zone.walkable, {30, 5}));
}

TEST(OpenSpace, goes_round_water_and_over_footways) {
  Street path{"path", {{-20, 6}, {80, 6}}, "highway.footway"};
  Scene scene;
  scene.add({"street", kStreet}).add(path).add_polygon("pond", "water", rectangle(20, -8, 40, -3));
  const Zone zone = scene.zone();
  EXPECT_TRUE(contains(zone.walkable, {30, 6}));
  EXPECT_TRUE(contains(zone.walkable, {30, 10}));
  EXPECT_FALSE(contains(zone.walkable, {30, -5}));
  EXPECT_TRUE(contains(zone.walkable, {30, -10}));
}

TEST(OpenSpace, a_road_on_a_bridge_does_not_end_it) {
  Street bridge{"bridge", {{-40, 7}, {100, 7}}, "highway.residential"};
  bridge.persons = false;
  bridge.vehicles = true;
  bridge.z = {6.0, 6.0};
  Scene scene;
  scene.add({"street", kStreet}).add(bridge);
  EXPECT_TRUE(contains(scene.zone().walkable, {30, 10}));
}

TEST(Levels, the_edge_with_fewer_links_is_left_out) {
  Street bridge{"bridge", {{30, -40}, {30, 40}}};
  bridge.z = {5.0, 5.0};
  Scene scene;
  scene.add({"west", {{0, 0}, {25, 0}}, "highway.pedestrian", "a", "b"})
      .add({"middle", {{26, 0}, {35, 0}}, "highway.pedestrian", "b", "c"})
      .add(bridge);
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_THAT(edge_ids(scene.network(), zone), ElementsAre("middle", "west"));
  EXPECT_THAT(zone.warnings, ElementsAre("edge 'bridge' is on another level than edge 'middle' "
                                         "that it overlaps: left out"));
}

TEST(Levels, slopes_that_meet_on_one_level_and_small_steps_are_no_conflict) {
  for (const auto& [height, edges] : {std::pair{2.4, 2u}, {2.6, 1u}}) {
    Street other{"other", {{30, -40}, {30, 40}}};
    other.z = {height, height};
    Scene scene;
    scene.add({"street", kStreet}).add(other);
    EXPECT_EQ(scene.zone().edges.size(), edges) << height;
  }
  Street ramp{"ramp", {{60, 0}, {60, 40}}};
  ramp.z = {0.0, 8.0};
  Scene scene;
  scene.add({"street", kStreet}).add(ramp);
  EXPECT_EQ(scene.zone().edges.size(), 2u);
}

TEST(Junctions, a_house_on_the_way_between_two_edges_is_cut_open) {
  Scene scene;
  scene.add({"west", {{0, 0}, {25, 0}}, "highway.pedestrian", "a", "b"})
      .add({"east", {{35, 0}, {60, 0}}, "highway.pedestrian", "b", "c"})
      .add_building("kiosk", rectangle(28, -3, 32, 3));
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_LT(zone.ways.distance({5, 0}, {55, 0}), 50.5);
  EXPECT_THAT(zone.warnings, ElementsAre("polygon 'kiosk' closes the way between edges 'west' and "
                                         "'east' at junction 'b': cut open"));
}

TEST(Junctions, a_house_that_leaves_a_way_round_it_stays) {
  Scene scene;
  scene.add({"west", {{0, 0}, {25, 0}}, "highway.pedestrian", "a", "b"})
      .add({"east", {{35, 0}, {60, 0}}, "highway.pedestrian", "b", "c"})
      .add_building("kiosk", rectangle(28, -3, 32, 3));
  const Zone zone = scene.zone();  // with open space
  EXPECT_THAT(zone.warnings, IsEmpty());
  EXPECT_FALSE(contains(zone.walkable, {30, 0}));
  EXPECT_LT(zone.ways.distance({5, 0}, {55, 0}), 54.0);
}

TEST(Junctions, very_short_edges_are_walkable_and_linked) {
  Scene scene;
  scene.add({"west", {{0, 0}, {25, 0}}, "highway.pedestrian", "a", "b"})
      .add({"bit", {{25.5, 0}, {25.7, 0}}, "highway.pedestrian", "b", "c"})
      .add({"east", {{26.2, 0}, {60, 0}}, "highway.pedestrian", "c", "d"});
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_EQ(zone.links.size(), 2u);
  EXPECT_TRUE(contains(zone.walkable, {25.6, 0}));
  EXPECT_LT(zone.ways.distance({5, 0}, {55, 0}), 50.5);
}

}  // namespace
}  // namespace pedzone::test
