// Crosswalks, and who uses them, on a network built by netconvert with a zebra crossing of 4 m at
// either end of a street of 7 m.
#include "zone/crosswalks.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "scene.hpp"
#include "sumo/files/net_reader.hpp"

namespace pedzone::test {
namespace {

class CrosswalksTest : public ::testing::Test {
 protected:
  static Crosswalks of(const Network& network) {
    ZoneSpec spec;
    spec.edges = {"eastward", "westward"};
    return build_zones(network, {spec}).front().crosswalks;
  }

  /// Whether somebody is on a crossing of (0, 0) to (0, 7), 4 m wide, or within 1.5 m of it.
  static bool uses(const Vec2& here, const Vec2& aim) {
    return one().ahead(here, aim, 1.5).has_value();
  }

  static Crosswalks one() { return Crosswalks({{{0.0, 0.0}, {0.0, 7.0}, 4.0}}); }

  const Network street_ = read_network(network_file("shopping-street/shopping-street.net.xml"));
};

TEST_F(CrosswalksTest, are_the_crossings_of_a_zone_over_carriageways) {
  const Crosswalks found = of(street_);
  ASSERT_EQ(found.size(), 2U);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_NEAR((found[k].end - found[k].begin).norm(), 7.0, 1e-9);
    EXPECT_EQ(found[k].width, 4.0);
    EXPECT_TRUE(found[k].priority);
  }
}

TEST_F(CrosswalksTest, are_none_under_a_traffic_light) {
  Network network = street_;
  network.edges[network.edge_index.at(":west_c1")].signalled = true;
  EXPECT_EQ(of(network).size(), 1U);
}

TEST_F(CrosswalksTest, are_none_where_people_may_walk_among_the_vehicles) {
  Network network = street_;
  for (const std::string& id : network.edges[network.edge_index.at(":west_c1")].crossed) {
    for (const int lane : network.edges[network.edge_index.at(id)].lanes) {
      network.lanes[lane].persons = true;
    }
  }
  EXPECT_LT(of(network).size(), 2U);
}

TEST_F(CrosswalksTest, are_used_by_who_is_on_them_or_looks_across_at_the_kerb) {
  EXPECT_TRUE(uses({0.0, -1.0}, {0.0, 9.0}));
  EXPECT_TRUE(uses({2.2, 3.0}, {1.0, 9.0}));
  EXPECT_TRUE(uses({0.0, 8.0}, {0.0, -9.0}));
}

TEST_F(CrosswalksTest, are_not_used_by_who_walks_past_or_has_come_over) {
  EXPECT_FALSE(uses({0.0, -1.0}, {20.0, 2.0}));   // along the street
  EXPECT_FALSE(uses({0.0, -3.0}, {0.0, 9.0}));    // not at the kerb yet
  EXPECT_FALSE(uses({4.0, -1.0}, {4.0, 9.0}));    // beside it
  EXPECT_FALSE(uses({0.0, 7.1}, {0.0, 20.0}));    // over it
  EXPECT_FALSE(uses({0.0, -1.0}, {0.0, -20.0}));  // away from it
}

TEST_F(CrosswalksTest, begin_where_their_user_comes_from) {
  EXPECT_EQ(one().ahead({0.0, 6.0}, {0.0, -5.0}, 1.5)->crosswalk.begin.y(), 7.0);
  EXPECT_EQ(one().ahead({0.0, 1.0}, {0.0, 12.0}, 1.5)->crosswalk.begin.y(), 0.0);
  EXPECT_EQ(one().ahead({0.0, 1.0}, {0.0, 12.0}, 1.5)->gone, 1.0);
  EXPECT_EQ(one().ahead({0.0, -1.0}, {0.0, 12.0}, 1.5)->gone, -1.0);
}

TEST_F(CrosswalksTest, are_found_among_many_as_if_each_were_looked_at) {
  std::vector<Crosswalk> many;
  for (int k = 0; k < 60; ++k) {
    const Vec2 at(17.0 * (k % 8), 23.0 * (k / 8));
    many.push_back({at, at + Vec2(k % 3, 4.0 + k % 9), 3.0 + k % 2, k % 2 == 0});
  }
  const Crosswalks all(many);
  int found = 0;
  for (int n = 0; n < 20000; ++n) {
    const Vec2 here(0.7 * (n % 200), 1.9 * (n / 200)), aim = here + Vec2(1.0, n % 2 == 0 ? 9 : -9);
    std::optional<std::size_t> kerb;
    for (std::size_t k = 0; k < many.size() && !kerb; ++k) {
      const auto alone = Crosswalks({many[k]}).ahead(here, aim, 3.0);
      if (alone) kerb = 2 * k + alone->kerb;
    }
    const auto together = all.ahead(here, aim, 3.0);
    ASSERT_EQ(together.has_value(), kerb.has_value()) << here.transpose();
    if (kerb) {
      EXPECT_EQ(together->kerb, *kerb);
    }
    found += kerb ? 1 : 0;
  }
  EXPECT_GT(found, 1000);
}

TEST_F(CrosswalksTest, a_way_leads_over_one_where_it_meets_its_middle) {
  const Crosswalk crosswalk{{0.0, 0.0}, {0.0, 7.0}, 4.0};
  const auto over = way_over(std::vector<Vec2>{{-20.0, 2.0}, {-10.0, 2.0}, {10.0, 2.0}}, crosswalk);
  ASSERT_TRUE(over);
  EXPECT_EQ(over->way, 20.0);
  EXPECT_EQ(over->across, 2.0);
  EXPECT_EQ(over->direction, Vec2(1.0, 0.0));
  EXPECT_FALSE(way_over(std::vector<Vec2>{{-20.0, 8.0}, {10.0, 8.0}}, crosswalk));
  EXPECT_FALSE(way_over(std::vector<Vec2>{{-20.0, 2.0}, {-1.0, 2.0}}, crosswalk));
}

TEST_F(CrosswalksTest, cover_what_is_between_their_kerbs) {
  EXPECT_TRUE(one().covers({1.9, 0.1}));
  EXPECT_TRUE(one().covers({-1.9, 6.9}));
  EXPECT_FALSE(one().covers({2.1, 3.0})) << "beside";
  EXPECT_FALSE(one().covers({0.0, -0.1})) << "at the kerb";
  EXPECT_FALSE(one().covers({0.0, 7.1}));
}

}  // namespace
}  // namespace pedzone::test
