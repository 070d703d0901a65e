// Two judges of the overlay that share nothing with it: Boost.Geometry, and shapes::defect(), which
// looks at every pair of edges.
#include <gtest/gtest.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/geometries.hpp>

#include "shapes.hpp"

namespace pedzone {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false, false>;
using BoostRegion = bg::model::multi_polygon<BoostPolygon>;
using shapes::Random;

TEST(Overlay, of_many_edges_on_few_points_is_valid) {
  // Corners on edges, edges on edges or a millimetre beside them.
  Random random(41);
  int polygons = 0;
  for (int round = 0; round < 500; ++round) {
    const std::uint64_t size = 3 + random() % 40;
    const auto coordinate = [&] {
      return 0.5 * static_cast<double>(random() % size) + 0.001 * static_cast<double>(random() % 3);
    };
    Ring ring;
    const std::uint64_t count = 3 + random() % 20;
    for (std::uint64_t i = 0; i < count; ++i) ring.emplace_back(coordinate(), coordinate());
    const Region region = repair(ring);
    ASSERT_EQ(shapes::defect(region), "") << round;
    polygons += static_cast<int>(region.size());
  }
  EXPECT_GT(polygons, 1000);
}

TEST(Overlay, of_long_edges_that_are_nearly_parallel_is_valid) {
  Random random(42);
  int polygons = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Region> strips;
    for (int i = 0; i < 6; ++i) {
      Ring ring;
      for (int k = 0; k < 6; ++k) {
        const double along = 1e-3 * static_cast<double>(random() % 100000);
        const double beside = 1e-3 * static_cast<double>(random() % 5) + (k < 3 ? 0.0 : 0.5);
        ring.emplace_back(along, along / 3.0 + beside);
      }
      strips.push_back(repair(ring));
    }
    const Region region = unite(strips);
    ASSERT_EQ(shapes::defect(region), "") << round;
    polygons += static_cast<int>(region.size());
  }
  EXPECT_GT(polygons, 200);
}

BoostRegion boost_region(const Region& region) {
  BoostRegion out;
  for (const Polygon& polygon : region) {
    BoostPolygon copy;
    for (const Vec2& point : polygon.outer) copy.outer().emplace_back(point.x(), point.y());
    for (const Ring& hole : polygon.holes) {
      copy.inners().emplace_back();
      for (const Vec2& point : hole) copy.inners().back().emplace_back(point.x(), point.y());
    }
    out.push_back(copy);
  }
  return out;
}

TEST(SecondOpinion, of_boost_geometry_agrees_on_areas_and_validity) {
  Random random(44);
  for (int round = 0; round < 60; ++round) {
    const Region a = shapes::obstacle_scene(random, 40.0, 20),
                 b = shapes::obstacle_scene(random, 50.0, 20);
    const BoostRegion boost_a = boost_region(a), boost_b = boost_region(b);
    ASSERT_TRUE(bg::is_valid(boost_a));
    BoostRegion sum, common, rest;
    bg::union_(boost_a, boost_b, sum);
    bg::intersection(boost_a, boost_b, common);
    bg::difference(boost_a, boost_b, rest);
    // Half a grid step along borders of some hundred metres, and slivers left out.
    const double tolerance = 0.3;
    EXPECT_NEAR(area(unite(a, b)), bg::area(sum), tolerance);
    EXPECT_NEAR(area(intersect(a, b)), bg::area(common), tolerance);
    EXPECT_NEAR(area(subtract(a, b)), bg::area(rest), tolerance);
    for (const Region& region :
         {unite(a, b), intersect(a, b), subtract(a, b), grow(a, -0.3), grow(a, 1.0)}) {
      std::string message;
      EXPECT_TRUE(bg::is_valid(boost_region(region), message)) << message;
    }
  }
}

TEST(SecondOpinion, of_boost_geometry_agrees_on_grown_and_shrunk_areas) {
  Random random(45);
  for (int round = 0; round < 20; ++round) {
    const Region scene = shapes::obstacle_scene(random, 40.0, 15);
    for (const double distance : {-0.5, -0.2, 0.5, 3.0}) {
      BoostRegion grown;
      bg::buffer(boost_region(scene), grown,
                 bg::strategy::buffer::distance_symmetric<double>(distance),
                 bg::strategy::buffer::side_straight(), bg::strategy::buffer::join_round(90),
                 bg::strategy::buffer::end_round(90), bg::strategy::buffer::point_circle(90));
      // Chords of arcs: 1 cm each, some of them at each of a hundred corners.
      EXPECT_NEAR(area(grow(scene, distance)), bg::area(grown), 0.003 * bg::area(grown))
          << distance;
    }
  }
}

}  // namespace
}  // namespace pedzone
