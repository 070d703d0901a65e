// Zebra crossings, and who uses them, on a network built by netconvert with a zebra crossing of 4 m
// at either end of a street of 7 m.
#include "zone/zebras.hpp"

#include <gmock/gmock.h>

#include "scene.hpp"
#include "sumo/files/net_reader.hpp"

namespace pedzone::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

class Zebras : public ::testing::Test {
 protected:
  static Zone zone(const Network& network, CrossingRule crossing) {
    ZoneSpec spec;
    spec.edges = {"eastward", "westward"};
    spec.crossing = crossing;
    return build_zones(network, {spec}).front();
  }

  /// Whether somebody uses a crossing of (0, 0) to (0, 7), 4 m wide.
  static bool uses(const Vec2& here, const Vec2& aim) {
    const std::vector<Zebra> one{{{0.0, 0.0}, {0.0, 7.0}, 4.0}};
    return zebra_of(one, here, aim).has_value();
  }

  const Network street_ = read_network(network_file("shopping-street/shopping-street.net.xml"));
};

TEST_F(Zebras, are_the_crossings_with_priority_of_a_zone_with_streets) {
  // Two more lead over side streets, at which vehicles do not give way.
  const Zone found = zone(street_, CrossingRule::kAnywhere);
  ASSERT_THAT(found.zebras, SizeIs(2));
  for (const Zebra& zebra : found.zebras) {
    EXPECT_NEAR((zebra.end - zebra.begin).norm(), 7.0, 1e-9);
    EXPECT_EQ(zebra.width, 4.0);
  }
  EXPECT_THAT(zone(street_, CrossingRule::kNodes).zebras, IsEmpty());
}

TEST_F(Zebras, are_none_under_a_traffic_light) {
  Network network = street_;
  network.edges[network.edge_index.at(":west_c1")].signalled = true;
  EXPECT_THAT(zone(network, CrossingRule::kAnywhere).zebras, SizeIs(1));
}

TEST_F(Zebras, are_used_by_who_is_on_them_or_looks_across_at_the_kerb) {
  EXPECT_TRUE(uses({0.0, -1.0}, {0.0, 9.0}));
  EXPECT_TRUE(uses({2.2, 3.0}, {1.0, 9.0}));
  EXPECT_TRUE(uses({0.0, 8.0}, {0.0, -9.0}));
}

TEST_F(Zebras, are_not_used_by_who_walks_past_or_has_come_over) {
  EXPECT_FALSE(uses({0.0, -1.0}, {20.0, 2.0}));   // along the street
  EXPECT_FALSE(uses({0.0, -3.0}, {0.0, 9.0}));    // not at the kerb yet
  EXPECT_FALSE(uses({4.0, -1.0}, {4.0, 9.0}));    // beside it
  EXPECT_FALSE(uses({0.0, 7.1}, {0.0, 20.0}));    // over it
  EXPECT_FALSE(uses({0.0, -1.0}, {0.0, -20.0}));  // away from it
}

TEST_F(Zebras, begin_where_their_user_comes_from) {
  const std::vector<Zebra> one{{{0.0, 0.0}, {0.0, 7.0}, 4.0}};
  EXPECT_EQ(zebra_of(one, {0.0, 6.0}, {0.0, -5.0})->begin.y(), 7.0);
  EXPECT_EQ(zebra_of(one, {0.0, 1.0}, {0.0, 12.0})->begin.y(), 0.0);
}

}  // namespace
}  // namespace pedzone::test
