// A real town centre (networks/bad-hersfeld): every way that SUMO's persons have stays open.
#include <gmock/gmock.h>

#include <map>

#include "scene.hpp"
#include "sumo/files/net_reader.hpp"
#include "zone/shapes.hpp"
#include "zone/zone_distance.hpp"

namespace pedzone::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

struct Town {
  Network network;
  Zone zone;
};

/// Built once for all tests.
const Town& town(const std::string& name) {
  static std::map<std::string, Town> towns;
  const auto [entry, fresh] = towns.try_emplace(name);
  if (fresh) {
    const std::string folder = network_file("bad-hersfeld/");
    Town& built = entry->second;
    built.network = read_network(folder + name + ".net.xml.gz");
    read_shapes(folder + name + ".poly.xml", built.network);
    built.zone = build_zones(built.network, {}).front();
  }
  return entry->second;
}

class TownCentre : public ::testing::TestWithParam<const char*> {
 protected:
  const Network& network_ = town(GetParam()).network;
  const Zone& zone_ = town(GetParam()).zone;
};

TEST_P(TownCentre, has_the_streets_that_its_readme_names) {
  double pedestrian = 0.0, living = 0.0, service = 0.0, stubs = 0.0;
  for (const TypeLength& entry : zone_.inside) {
    if (entry.type == "highway.pedestrian") pedestrian = entry.length;
    if (entry.type == "highway.living_street") living = entry.length;
    if (entry.type == "highway.service") service = entry.length;
    if (entry.type == "highway.footway") stubs = entry.length;
  }
  // Without shuttles 86 m of "Am Brink", drawn in the middle of a road, are left out.
  const bool shuttles = std::string(GetParam()) == "centre-shuttle";
  EXPECT_NEAR(pedestrian, shuttles ? 3300 : 3214, 50);
  EXPECT_NEAR(living, 1800, 50);
  EXPECT_GT(service, 1500);
  EXPECT_LT(stubs, 1.0);
  EXPECT_EQ(zone_.inside.size(), 4u);
}

TEST_P(TownCentre, centre_lines_are_walkable_from_end_to_end) {
  for (const int index : zone_.lanes) {
    const Lane& lane = network_.lanes[index];
    if (network_.edges[lane.edge].function != EdgeFunction::kNormal) continue;
    for (std::size_t i = 0; i + 1 < lane.shape.size(); ++i) {
      const Vec2 piece = lane.shape[i + 1] - lane.shape[i];
      // Simplifying moves the border by 2 cm at most (kSimplification); a line's own end and a
      // building's wall may lie on it.
      for (double along = 0.05; along < piece.norm() - 0.05; along += 0.25) {
        const Vec2 place = lane.shape[i] + piece.normalized() * along;
        EXPECT_LT((zone_.walls.nearest_inside(place, 0.0) - place).norm(), 0.03) << lane.id;
      }
    }
    const Vec2 start = inner_point(lane.shape, false, 0.5),
               end = inner_point(lane.shape, true, 0.5);
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < lane.shape.size(); ++i) {
      length += (lane.shape[i + 1] - lane.shape[i]).norm();
    }
    EXPECT_LE(zone_.ways.distance(start, end), length + 1.0) << lane.id;
  }
}

TEST_P(TownCentre, linked_edges_are_near_each_other_on_foot) {
  ASSERT_GT(zone_.links.size(), 300u);
  for (const auto& [pair, junctions] : zone_.links) {
    const auto [a, b] = pair;
    double air = 0.0, way = std::numeric_limits<double>::infinity();
    for (const bool a_end : {false, true}) {
      for (const bool b_end : {false, true}) {
        const Edge &from = network_.edges[a], &to = network_.edges[b];
        if ((a_end ? from.to : from.from) != (b_end ? to.to : to.from)) continue;
        const Vec2 p = inner_point(network_.lanes[walking_lane(network_, a)].shape, a_end, 0.5);
        const Vec2 q = inner_point(network_.lanes[walking_lane(network_, b)].shape, b_end, 0.5);
        air = (q - p).norm();
        way = std::min(way, zone_.ways.distance(p, q) - air);
      }
    }
    EXPECT_LT(way, 0.5 * air + 3.0) << network_.edges[a].id << " " << network_.edges[b].id;
  }
}

TEST_P(TownCentre, warns_of_each_building_that_was_cut) {
  int cut = 0;
  for (const std::string& warning : zone_.warnings) {
    if (warning.find("cut open") == std::string::npos) continue;
    ++cut;
    EXPECT_THAT(warning, HasSubstr("polygon '"));
  }
  EXPECT_GT(cut, 10);
}

TEST_P(TownCentre, only_zone_lanes_lie_on_buildings_or_ordinary_roads) {
  // What was cut open is no obstacle any more; simplifying moves borders by 2 cm.
  EXPECT_LT(area(intersect(zone_.walkable, zone_.obstacles)), 0.001 * area(zone_.walkable));
  std::vector<Region> roads, zone_lanes;
  for (const Lane& lane : network_.lanes) {
    const bool road = lane.vehicles && !lane.persons &&
                      network_.edges[lane.edge].function == EdgeFunction::kNormal;
    if (road) roads.push_back(area_of(lane));
  }
  for (const int lane : zone_.lanes) zone_lanes.push_back(area_of(network_.lanes[lane]));
  const Region shared = intersect(unite(roads), zone_.walkable);
  const Region without_lanes = subtract(shared, unite(zone_lanes));
  // Slits between shapes are closed; the lanes' own overlap is warned of.
  EXPECT_LT(area(without_lanes), 0.0005 * area(zone_.walkable));
  EXPECT_THAT(zone_.warnings, Contains(HasSubstr("which stays SUMO's")));
}

TEST_P(TownCentre, the_quick_distance_is_a_lower_bound) {
  const ZoneDistance quick(zone_);
  const WallIndex& walls = zone_.walls;
  Vec2 low = walls.walls().front().a, high = low;
  for (const Wall& wall : walls.walls()) {
    low = low.cwiseMin(wall.a);
    high = high.cwiseMax(wall.a);
  }
  const Vec2 border = Vec2::Constant(200.0), step = (high - low + 2.0 * border) / 60.0;
  int far = 0;
  for (int i = 0; i <= 60; ++i) {
    for (int j = 0; j <= 60; ++j) {
      const Vec2 point = low - border + step.cwiseProduct(Vec2(i, j));
      const double exact = (walls.nearest_inside(point, 0.0) - point).norm();
      EXPECT_LE(quick.at_least(point), exact + 1e-9) << i << " " << j;
      EXPECT_GE(quick.at_least(point), 0.5 * exact - 20.0) << i << " " << j;
      far += exact > 100.0;
    }
  }
  EXPECT_GT(far, 100);
}

INSTANTIATE_TEST_SUITE_P(BadHersfeld, TownCentre, ::testing::Values("centre", "centre-shuttle"),
                         [](const auto& value) {
                           return std::string(value.param) == "centre" ? "centre" : "shuttle";
                         });

}  // namespace
}  // namespace pedzone::test
