// Streets that may be crossed between the junctions, on a network built by netconvert: 200 m, two
// lanes of 3.5 m, sidewalks of 2 m, a zebra crossing at either end.
#include "zone/streets.hpp"

#include <gmock/gmock.h>

#include "scene.hpp"
#include "sumo/files/net_reader.hpp"

namespace pedzone::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class Streets : public ::testing::Test {
 protected:
  Zone zone(const Network& network, std::vector<std::string> edges,
            CrossingRule crossing = CrossingRule::kAnywhere) const {
    ZoneSpec spec;
    spec.edges = std::move(edges);
    spec.crossing = crossing;
    return build_zones(network, {spec}).front();
  }

  const Network town_ = read_network(network_file("shopping-street/shopping-street.net.xml"));
  const Zone zone_ = zone(town_, {"eastward", "westward"});
};

TEST_F(Streets, are_found_between_two_sidewalks_with_their_lanes_and_directions) {
  ASSERT_THAT(zone_.streets, SizeIs(1));
  const pedzone::Street& street = zone_.streets.front();
  EXPECT_NEAR(street.length, 200.0, 1e-9);
  EXPECT_NEAR(street.high - street.low, 7.0, 1e-9);
  ASSERT_THAT(street.lanes, SizeIs(2));
  EXPECT_EQ(street.lanes[0].direction * street.lanes[1].direction, -1);
  const CrossingPlace& middle = street.at(100.0);
  EXPECT_TRUE(middle.open);
  EXPECT_FALSE(middle.near_signal);
  EXPECT_NEAR(middle.low, street.low, 0.15);
  EXPECT_NEAR(middle.high, street.high, 0.15);
}

TEST_F(Streets, have_two_halves_that_meet_where_the_direction_changes) {
  EXPECT_NEAR(zone_.streets.front().divide(),
              0.5 * (zone_.streets.front().low + zone_.streets.front().high), 1e-9);
  pedzone::Street three_lanes;
  three_lanes.low = -6.5;
  three_lanes.high = 4.0;
  three_lanes.lanes = {{0, -6.5, -3.0, 1}, {1, -3.0, 0.5, 1}, {2, 0.7, 4.0, -1}};
  EXPECT_NEAR(three_lanes.divide(), 0.6, 1e-9);
  three_lanes.lanes.back().direction = 1;  // one way
  EXPECT_NEAR(three_lanes.divide(), -1.25, 1e-9);
}

TEST_F(Streets, have_places_along_and_beside_the_axis_and_beyond_its_ends) {
  const pedzone::Street& street = zone_.streets.front();
  const StreetPlace here = street.place(street.point(30.0, 2.0));
  EXPECT_NEAR(here.s, 30.0, 1e-9);
  EXPECT_NEAR(here.t, 2.0, 1e-9);
  const StreetPlace before = street.place(street.point(0.0, 1.0) - 25.0 * here.direction);
  EXPECT_NEAR(before.s, -25.0, 1e-9);
  EXPECT_NEAR(before.t, 1.0, 1e-9);
}

TEST_F(Streets, open_the_walls_for_who_crosses_only) {
  EXPECT_FALSE(zone_.walls.inside({100.0, 0.0}));
  EXPECT_TRUE(zone_.street_walls.inside({100.0, 0.0}));
  EXPECT_TRUE(zone_.street_walls.free_line({100.0, -4.5}, {100.0, 4.5}, 0.2));
  EXPECT_FALSE(zone_.street_walls.inside({100.0, 6.5}));
}

TEST_F(Streets, open_the_walls_for_bodies_wherever_one_may_step_out) {
  pedzone::Street street = zone_.streets.front();
  street.places.assign(street.places.size(), street.at(100.0));
  for (std::size_t k = 0; k < street.places.size(); ++k) street.places[k].open = k == 50 || k > 190;
  const WallIndex ground{crossable_ground({street})};
  const double middle = 0.5 * (street.low + street.high);
  for (const double s : {49.51, 50.49, 190.51, street.length}) {
    ASSERT_TRUE(street.at(s).open);
    EXPECT_TRUE(ground.inside(street.point(s, middle))) << s;
    EXPECT_GT(ground.room(street.point(s, middle), 1.0), 0.24) << s;
  }
}

TEST_F(Streets, link_the_edges_on_their_two_sides) {
  EXPECT_TRUE(linked(zone_, town_.edge_index.at("eastward"), town_.edge_index.at("westward")));
  EXPECT_THAT(linked_across(town_, zone_.streets, {town_.edge_index.at("eastward")}), IsEmpty());
}

TEST_F(Streets, link_to_a_footway_that_is_an_edge_of_its_own) {
  constexpr double kLaneWidth = 3.5;
  Network one_way = town_;
  Edge& back = one_way.edges[one_way.edge_index.at("westward")];
  std::erase_if(back.lanes, [&](int lane) { return !one_way.lanes[lane].persons; });
  for (Vec2& point : one_way.lanes[back.lanes.front()].shape) point.y() -= kLaneWidth;
  const Zone zone_there = zone(one_way, {"eastward", "westward"});
  ASSERT_THAT(zone_there.streets, SizeIs(1));
  EXPECT_TRUE(
      linked(zone_there, one_way.edge_index.at("eastward"), one_way.edge_index.at("westward")));
}

TEST_F(Streets, are_none_unless_asked_for) {
  const Zone plain = zone(town_, {"eastward", "westward"}, CrossingRule::kNodes);
  EXPECT_THAT(plain.streets, IsEmpty());
  EXPECT_TRUE(plain.street_walls.walls().empty());
}

TEST_F(Streets, need_ground_on_both_sides) {
  const Zone one_side = zone(town_, {"eastward"});
  EXPECT_THAT(one_side.streets, IsEmpty());
  EXPECT_THAT(one_side.warnings, ElementsAre(HasSubstr("crossing=\"anywhere\" changes nothing")));
}

TEST_F(Streets, are_not_open_where_vehicles_appear) {
  Network town = town_;
  const Edge& eastward = town.edges[town.edge_index.at("eastward")];
  town.junctions[town.junction_index.at(eastward.from)].street_end = true;
  const std::vector<pedzone::Street> streets = zone(town, {"eastward", "westward"}).streets;
  ASSERT_THAT(streets, SizeIs(1));
  const double end = streets[0].place(town.lanes[eastward.lanes[0]].shape.front()).s;
  const double inwards = end < 100.0 ? 1.0 : -1.0;
  EXPECT_TRUE(zone_.streets[0].at(end + inwards * 14.0).open);
  EXPECT_FALSE(streets[0].at(end + inwards * 14.0).open);
  EXPECT_TRUE(streets[0].at(end + inwards * 16.0).open);
  // The lanes beside may all be for vehicles.
  for (const int lane : town.edges[town.edge_index.at("westward")].lanes) {
    town.lanes[lane].persons = false;
  }
  EXPECT_THAT(zone(town, {"eastward"}).streets, IsEmpty());
}

TEST_F(Streets, are_not_open_near_a_signalled_crossing) {
  Network network = town_;
  network.edges[network.edge_index.at(":west_c1")].signalled = true;
  const Zone signalled = zone(network, {"eastward", "westward"});
  ASSERT_THAT(signalled.streets, SizeIs(1));
  const pedzone::Street& street = signalled.streets.front();
  const double west = street.place({7.5, 0.0}).s;  // two metres from the crossing
  const auto from_west = [&](double metres) {
    return west < 1.0 ? metres : street.length - metres;
  };
  EXPECT_TRUE(street.at(from_west(20.0)).near_signal);
  EXPECT_FALSE(street.at(from_west(35.0)).near_signal);
}

}  // namespace
}  // namespace pedzone::test
