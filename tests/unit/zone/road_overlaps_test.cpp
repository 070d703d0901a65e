// Footpaths that maps draw over roads: where a road covers them, SUMO keeps its people.
#include "zone/road_overlaps.hpp"

#include <gmock/gmock.h>

#include "scene.hpp"

namespace pedzone::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A square of its own far from everything, a road of 6 m along the x axis, and what a test adds.
class RoadOverlaps : public ::testing::Test {
 protected:
  RoadOverlaps() {
    scene_.add({"square", {{0, 100}, {50, 100}}}).add_road("road", {{0, 0}, {100, 0}});
  }

  /// Ids of the edges in the zone, without open space round them.
  std::vector<std::string> edges() const {
    return edge_ids(scene_.network(), scene_.zone({closed_spec()}));
  }

  Scene scene_;
};

TEST_F(RoadOverlaps, leaves_out_a_path_in_the_middle_of_a_road_and_names_both) {
  scene_.add({"path", {{10, 0}, {40, 0}}});
  EXPECT_THAT(edges(), ElementsAre("square"));
  EXPECT_THAT(scene_.zone({closed_spec()}).warnings,
              Contains(HasSubstr("edge 'path' runs under 'road_0', with no room beside")));
}

TEST_F(RoadOverlaps, leaves_out_a_path_that_comes_out_from_under_a_road) {
  scene_.add({"path", {{20, 0}, {60, 20}}});
  EXPECT_THAT(edges(), ElementsAre("square"));
}

TEST_F(RoadOverlaps, takes_a_path_across_a_road) {
  scene_.add({"path", {{40, -20}, {60, 20}}});
  EXPECT_THAT(edges(), ElementsAre("path", "square"));
}

TEST_F(RoadOverlaps, takes_a_path_beside_a_road_and_one_under_it_for_a_step_or_two) {
  scene_.add({"beside", {{10, 4}, {40, 4}}}).add({"short", {{99.5, 0}, {130, 0}}});
  EXPECT_THAT(edges(), ElementsAre("beside", "short", "square"));
}

TEST_F(RoadOverlaps, takes_a_path_that_is_wider_than_the_road) {
  Street path{"path", {{10, 0}, {40, 0}}};
  path.width = 7.8;
  scene_.add(path);
  EXPECT_THAT(edges(), ElementsAre("path", "square"));
}

TEST_F(RoadOverlaps, takes_a_path_with_another_beside_it_that_no_road_covers) {
  scene_.add({"path", {{10, 2}, {40, 2}}}).add({"beside", {{10, 4}, {40, 4}}});
  EXPECT_THAT(edges(), ElementsAre("beside", "path", "square"));
}

TEST_F(RoadOverlaps, takes_a_path_with_open_space_beside_it_but_not_beyond_the_road) {
  ZoneSpec open = closed_spec();
  open.open_space = 10.0;
  scene_.add({"path", {{10, 2.2}, {40, 2.2}}}).add({"middle", {{50, 0}, {80, 0}}});
  EXPECT_THAT(edge_ids(scene_.network(), scene_.zone({open})), ElementsAre("path", "square"));
}

TEST_F(RoadOverlaps, takes_a_path_on_ground_that_the_user_drew) {
  scene_.add({"path", {{10, 0}, {40, 0}}})
      .add_polygon("ground", "pedzone.walkable", rectangle(5, -10, 45, 10));
  EXPECT_THAT(edges(), ElementsAre("path", "square"));
}

TEST_F(RoadOverlaps, takes_a_path_on_a_bridge_over_the_road) {
  Street bridge{"bridge", {{10, 0}, {40, 0}}};
  bridge.z = {6, 6};
  scene_.add(bridge);
  EXPECT_THAT(edges(), ElementsAre("bridge", "square"));
}

TEST(RoadOverlapsAlone, zone_that_is_nothing_but_such_a_path_keeps_it) {
  Scene scene;
  scene.add({"path", {{10, 0}, {40, 0}}}).add_road("road", {{0, 0}, {100, 0}});
  const Zone zone = scene.zone({closed_spec()});
  EXPECT_THAT(edge_ids(scene.network(), zone), ElementsAre("path"));
  EXPECT_THAT(zone.warnings, Contains(HasSubstr("which stays SUMO's")));
}

}  // namespace
}  // namespace pedzone::test
