// The selection rule on a town built by netconvert (data/town.edg.xml has one edge of each case).
#include "zone/selection.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "scene.hpp"
#include "sumo/files/net_reader.hpp"
#include "zone/links.hpp"

namespace pedzone::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

class Town : public ::testing::Test {
 protected:
  int edge(const std::string& id) const { return town_.edge_index.at(id); }
  bool linked_ids(const Zone& zone, const std::string& a, const std::string& b) const {
    return linked(zone, edge(a), edge(b));
  }
  Zone zone(const ZoneSpec& spec = {}) const { return build_zones(town_, {spec}).front(); }

  const Network town_ = read_network(data_file("town.net.xml"));
};

TEST_F(Town, takes_pedestrian_and_living_streets_and_slow_shared_lanes_only) {
  EXPECT_THAT(edge_ids(town_, zone()),
              UnorderedElementsAre("old_north", "old_south", "living_north", "-living_north",
                                   "living_south", "-living_south", "service"));
}

TEST_F(Town, shares_the_whole_of_junctions_without_a_carriageway_only) {
  std::vector<int> edges;
  for (const char* id : {"main1", "-main1", "main2", "-main2", "old_north", "old_south", "service",
                         "living_north", "-living_north", "gravel", "footway"}) {
    edges.push_back(edge(id));
  }
  std::vector<std::string> shared;
  for (const int index : shared_junctions(town_, edges)) {
    shared.push_back(town_.junctions[index].id);
  }
  EXPECT_THAT(shared, UnorderedElementsAre("corner", "north"));
  edges.pop_back();
  EXPECT_EQ(shared_junctions(town_, edges).size(), 2u) << "a footway that stays SUMO's is no road";
  edges.pop_back();
  EXPECT_EQ(shared_junctions(town_, edges).size(), 1u) << "a road that stays SUMO's";
}

TEST_F(Town, leaves_out_the_bridge_with_a_warning_that_names_both) {
  EXPECT_THAT(zone().warnings, ElementsAre("edge 'bridge' is on another level than edge "
                                           "'old_south' that it overlaps: left out"));
}

TEST_F(Town, lists_lengths_inside_and_what_would_bring_the_rest_in) {
  const Zone all = zone();
  const auto entry = [](const std::vector<TypeLength>& list, const std::string& type) {
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const auto& e) { return e.type == type; });
    return found == list.end() ? TypeLength{} : *found;
  };
  EXPECT_NEAR(entry(all.inside, "highway.living_street").length, 2 * 65.6 + 2 * 72.8, 1e-6);
  EXPECT_EQ(entry(all.inside, "highway.pedestrian").edges, 2);
  EXPECT_EQ(entry(all.left_out, "highway.residential").edges, 6);  // their sidewalks
  EXPECT_EQ(entry(all.left_out, "highway.footway").bring_in, "edgeTypes=\"highway.footway\"");
  EXPECT_NEAR(entry(all.left_out, "highway.service").length, 100.0, 1e-6);
  EXPECT_EQ(entry(all.left_out, "highway.unsurfaced").edges, 1);
  EXPECT_TRUE(std::is_sorted(all.left_out.begin(), all.left_out.end(),
                             [](const auto& a, const auto& b) { return a.length > b.length; }));
}

TEST_F(Town, passes_unsignalled_crossings_and_leaves_signalled_ones_to_sumo) {
  const Zone all = zone();
  EXPECT_TRUE(linked_ids(all, "old_north", "old_south"));
  EXPECT_FALSE(linked_ids(all, "living_north", "living_south"));
  EXPECT_FALSE(linked_ids(all, "-living_north", "-living_south"));
  const auto lanes = lane_ids(town_, all);
  EXPECT_THAT(lanes, IsSupersetOf({":crossing_c0_0", ":crossing_w0_0", ":crossing_w1_0"}));
  for (const std::string& lane : lanes) EXPECT_THAT(lane, Not(HasSubstr(":lights_c")));
}

TEST_F(Town, walks_through_an_unsignalled_crossing_inside_its_area) {
  const Zone all = zone();
  EXPECT_TRUE(all.walls.inside({-0.5, 0.0}));    // on the crossing
  EXPECT_FALSE(all.walls.inside({-30.0, 0.0}));  // on the road beside it
  EXPECT_FALSE(all.walls.inside({103.0, 0.0}));  // on the signalled crossing
  EXPECT_LT(all.ways.distance({-1.0, 20.0}, {-1.0, -20.0}), 42.0);
}

TEST_F(Town, takes_a_walking_area_between_two_zone_edges_but_not_one_that_only_touches_one) {
  // The service lane, the living street and the gravel road meet at the corner.
  const Zone all = zone();
  EXPECT_TRUE(linked_ids(all, "service", "living_north"));
  EXPECT_LT(all.ways.distance({90.0, 78.4}, {101.6, 65.0}), 25.0);
  // At the far end of the yard nothing else begins.
  ZoneSpec one;
  one.edges = {"old_north"};
  for (const std::string& lane : lane_ids(town_, zone(one))) EXPECT_THAT(lane, Not(HasSubstr(":")));
}

TEST_F(Town, a_named_zone_has_what_it_names_and_no_more) {
  ZoneSpec named;
  named.edges = {"footway"};
  named.edge_types = {"highway.service"};
  named.lanes = {"gravel_0"};
  EXPECT_THAT(edge_ids(town_, zone(named)),
              UnorderedElementsAre("footway", "service", "bus", "gravel"));
}

TEST_F(Town, an_edge_belongs_to_the_first_zone_that_names_it) {
  ZoneSpec rest, first, second;
  rest.id = "rest";
  first.id = "first";
  first.edges = {"old_north", "service"};
  second.id = "second";
  second.edges = {"service", "living_north"};
  const auto zones = build_zones(town_, {rest, first, second});
  EXPECT_THAT(edge_ids(town_, zones[1]), UnorderedElementsAre("old_north", "service"));
  EXPECT_THAT(edge_ids(town_, zones[2]), UnorderedElementsAre("living_north"));
  EXPECT_THAT(zones[2].warnings, Contains(HasSubstr("'service' belongs to the zone before it")));
  EXPECT_THAT(edge_ids(town_, zones[0]),
              UnorderedElementsAre("old_south", "-living_north", "living_south", "-living_south"));
}

TEST_F(Town, without_walking_areas_edges_that_meet_are_joined) {
  const Network bare = read_network(data_file("bare.net.xml"));
  const Zone all = build_zones(bare, {}).front();
  EXPECT_TRUE(linked(all, bare.edge_index.at("service"), bare.edge_index.at("living_north")));
  EXPECT_TRUE(linked(all, bare.edge_index.at("old_north"), bare.edge_index.at("old_south")));
  for (const auto& [pair, junctions] : all.links) {
    const auto [a, b] = pair;
    const Lane& from = bare.lanes[walking_lane(bare, a)];
    const Lane& to = bare.lanes[walking_lane(bare, b)];
    const Vec2 p = 0.5 * (from.shape[0] + from.shape[1]), q = 0.5 * (to.shape[0] + to.shape[1]);
    EXPECT_LT(all.ways.distance(p, q), 0.5 * (from.length + to.length) + 25.0)
        << from.id << " " << to.id;
  }
}

// netconvert builds no walking area where two streets meet in line, though elsewhere it does.
TEST(NarrowLane, streets_in_line_are_joined_where_the_junction_has_no_walking_area) {
  const Network lane = read_network(network_file("narrow-lane/narrow-lane.net.xml"));
  const Zone zone = build_zones(lane, {}).front();
  const auto edge = [&](const char* id) { return lane.edge_index.at(id); };
  EXPECT_TRUE(linked(zone, edge("west_street"), edge("lane_west")));
  EXPECT_TRUE(linked(zone, edge("lane_west"), edge("alley")));
  EXPECT_FALSE(linked(zone, edge("west_street"), edge("alley")));
}

// netconvert lays a walking area across the end of a street, too.
TEST(ShoppingStreet, people_pass_from_side_to_side_by_its_crossings_and_not_round_its_end) {
  Network network = read_network(network_file("shopping-street/shopping-street.net.xml"));
  ZoneSpec west;
  west.edges = {"in_west", "out_west"};
  const auto sides_linked = [&] {
    const Zone zone = build_zones(network, {west}).front();
    for (const std::string& lane : lane_ids(network, zone)) {
      EXPECT_THAT(lane, Not(HasSubstr(":far_west")));
    }
    return linked(zone, network.edge_index.at("in_west"), network.edge_index.at("out_west"));
  };
  EXPECT_TRUE(sides_linked());
  for (Edge& edge : network.edges) edge.signalled = edge.function == EdgeFunction::kCrossing;
  EXPECT_FALSE(sides_linked());
}

TEST_F(Town, unknown_or_unusable_names_are_errors_that_say_what_is_allowed) {
  ZoneSpec spec;
  spec.id = "z";
  spec.file = "z.xml";
  spec.line = 3;
  const auto with = [&](auto member, const std::string& value) {
    ZoneSpec wrong = spec;
    wrong.*member = {value};
    return complaint(town_, {wrong});
  };
  EXPECT_THAT(with(&ZoneSpec::edges, "nowhere"),
              HasSubstr("z.xml:3: <zone id=\"z\"> attribute edges: 'nowhere' is no edge; allowed: "
                        "ids of edges in"));
  EXPECT_THAT(with(&ZoneSpec::edges, ":crossing_w0"), HasSubstr("lies inside a junction"));
  EXPECT_THAT(with(&ZoneSpec::lanes, "main1_1"), HasSubstr("'main1_1' may not be used by persons"));
  EXPECT_THAT(with(&ZoneSpec::lanes, "main1_7"),
              HasSubstr("attribute lanes: 'main1_7' is no lane"));
  EXPECT_THAT(with(&ZoneSpec::edge_types, "highway.path"),
              HasSubstr("'highway.path' is the type of no edge; allowed: highway.footway, "));
  EXPECT_THAT(with(&ZoneSpec::polygons, "market"),
              HasSubstr("attribute polygons: 'market' is no polygon; allowed: "));
}

TEST_F(Town, a_zone_whose_edges_others_took_is_an_error) {
  ZoneSpec first, second;
  first.id = "first";
  first.file = second.file = "z.xml";
  first.edges = second.edges = {"service"};
  second.id = "second";
  EXPECT_THAT(complaint(town_, {first, second}), HasSubstr("<zone id=\"second\">: is empty"));
}

TEST(Selection, a_network_without_shared_space_is_an_error) {
  Scene scene;
  scene.add_road("road", {{0, 0}, {50, 0}});
  EXPECT_THAT(complaint(scene.network(), {}), HasSubstr("has no shared space"));
  Street slow{"slow", {{0, 20}, {50, 20}}};
  slow.type = "";
  slow.vehicles = slow.by_default = true;
  scene.add(slow);
  EXPECT_THAT(complaint(scene.network(), {}), HasSubstr("has no shared space"));
}

TEST(Selection, compound_types_count_by_their_parts) {
  Edge edge;
  edge.type = "railway.tram|highway.pedestrian";
  EXPECT_TRUE(has_type(edge, "highway.pedestrian"));
  EXPECT_TRUE(has_type(edge, edge.type));
  EXPECT_FALSE(has_type(edge, "highway.pedestrian_zone"));
  EXPECT_FALSE(has_type(edge, "pedestrian"));
}

TEST(Selection, the_speed_limit_of_shared_lanes_is_20_kilometres_per_hour) {
  for (const auto& [speed, inside] : {std::pair{5.6, true}, {5.56, true}, {5.61, false}}) {
    Scene scene;
    Street street{"s", {{0, 0}, {50, 0}}};
    street.type = "";
    street.vehicles = true;
    street.speed = speed;
    scene.add(street);
    EXPECT_EQ(is_shared_space(scene.network(), 0), inside) << speed;
  }
}

TEST(Selection, stubs_of_footways_between_junctions_of_the_zone_come_with_it) {
  Scene scene;
  scene.add({"west", {{0, 0}, {50, 0}}, "highway.pedestrian", "A", "B"});
  scene.add({"east", {{60, 0}, {110, 0}}, "highway.pedestrian", "C", "D"});
  const auto add_footway = [&](const std::string& id, double length, const std::string& to,
                               bool vehicles = false) {
    Street street{id, {{54, 0}, {54 + length, 0}}, "highway.footway", "B", to};
    street.vehicles = vehicles;
    street.speed = 13.9;
    scene.add(street);
  };
  add_footway("stub", 0.2, "C");
  add_footway("long", 2.5, "C");
  add_footway("astray", 0.2, "X");
  add_footway("road", 0.2, "C", true);
  EXPECT_THAT(edge_ids(scene.network(), scene.zone()), ElementsAre("east", "stub", "west"));
}

TEST(Selection, edges_without_types_are_brought_in_by_their_ids) {
  Scene scene;
  scene.add({"in", {{0, 0}, {50, 0}}});
  for (const std::string id : {"a", "b", "c"}) {
    Street street{id, {{0, 20}, {50, 20}}};
    street.type = "";
    scene.add(street);
  }
  const Zone zone = scene.zone();
  ASSERT_EQ(zone.left_out.size(), 1u);
  EXPECT_EQ(zone.left_out[0].edges, 3);
  EXPECT_EQ(zone.left_out[0].bring_in, "edges=\"a ...\"");
}

}  // namespace
}  // namespace pedzone::test
