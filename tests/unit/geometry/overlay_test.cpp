// The integer machinery under polygon.hpp, and a second opinion on its results: Boost.Geometry,
// which shares nothing with it.
#include "geometry/overlay.hpp"

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
using overlay::BorderPiece;
using overlay::GridPoint;
using shapes::Random;
using shapes::uniform;

void add_closed(const std::vector<GridPoint>& ring, std::vector<BorderPiece>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint &from = ring[i], &to = ring[(i + 1) % ring.size()];
    if (from == to) continue;
    edges.push_back(from < to ? BorderPiece{from, to, {1, 0}, {}}
                              : BorderPiece{to, from, {-1, 0}, {}});
  }
}

/// Twice the area of the triangle: its sign says on which side of a–b c lies. Exact.
std::int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether c lies on a–b, but not at an end of it.
bool lies_within(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return turn(a, b, c) == 0 && (c.x - a.x) * (c.x - b.x) + (c.y - a.y) * (c.y - b.y) < 0;
}

/// Whether two pieces have more in common than end points.
bool meet_within(const BorderPiece& one, const BorderPiece& other) {
  const GridPoint &a = one.from, &b = one.to, &c = other.from, &d = other.to;
  if (lies_within(a, b, c) || lies_within(a, b, d) || lies_within(c, d, a) ||
      lies_within(c, d, b)) {
    return true;
  }
  const auto sign = [](std::int64_t value) { return (value > 0) - (value < 0); };
  return (a == c && b == d) || (sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 &&
                                sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0);
}

/// Looks at every pair; shares nothing with overlay::is_arranged().
bool meet_at_ends_only(const std::vector<BorderPiece>& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (meet_within(edges[i], edges[j])) return false;
    }
  }
  return true;
}

TEST(Arrange, judge_knows_crossings_touches_and_twins) {
  const auto piece = [](GridPoint from, GridPoint to) { return BorderPiece{from, to, {1, 0}, {}}; };
  const BorderPiece level = piece({0, 0}, {10, 0});
  EXPECT_FALSE(meet_at_ends_only({level, piece({5, -5}, {6, 5})})) << "crossing";
  EXPECT_FALSE(meet_at_ends_only({level, piece({5, 0}, {6, 5})})) << "an end within";
  EXPECT_FALSE(meet_at_ends_only({level, piece({5, 0}, {20, 0})})) << "along each other";
  EXPECT_FALSE(meet_at_ends_only({level, level})) << "twice the same";
  EXPECT_TRUE(meet_at_ends_only({level, piece({10, 0}, {20, 0}), piece({0, 0}, {10, 1})}));
}

TEST(Arrange, leaves_edges_that_meet_in_end_points_only) {
  // Few cells, many edges: crossings on half cells, corners on edges, edges on edges.
  Random random(41);
  for (int round = 0; round < 2000; ++round) {
    const std::uint64_t size = 3 + random() % 40;
    const auto coordinate = [&] { return static_cast<std::int64_t>(random() % size) - 20; };
    std::vector<GridPoint> ring;
    const std::uint64_t count = 3 + random() % 20;
    for (std::uint64_t i = 0; i < count; ++i) ring.push_back({coordinate(), coordinate()});
    std::vector<BorderPiece> edges;
    add_closed(ring, edges);
    overlay::arrange(edges);
    ASSERT_TRUE(meet_at_ends_only(edges)) << round;
    ASSERT_TRUE(overlay::is_arranged(edges)) << round;
  }
}

TEST(Arrange, ends_for_long_edges_that_are_nearly_parallel) {
  Random random(42);
  for (int round = 0; round < 200; ++round) {
    std::vector<GridPoint> ring;
    for (int i = 0; i < 12; ++i) {
      const std::int64_t along = static_cast<std::int64_t>(random() % 100000);
      ring.push_back({along, along / 3 + static_cast<std::int64_t>(random() % 5)});
    }
    std::vector<BorderPiece> edges;
    add_closed(ring, edges);
    overlay::arrange(edges);
    ASSERT_TRUE(meet_at_ends_only(edges)) << round;
    ASSERT_TRUE(overlay::is_arranged(edges)) << round;
  }
}

TEST(Label, counts_how_often_rings_wind_round_a_place) {
  Random random(43);
  int looked_at = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<GridPoint> points;
    Ring ring;
    for (int i = 0; i < 9; ++i) {
      points.push_back({static_cast<std::int64_t>(random() % 10000),
                        static_cast<std::int64_t>(random() % 10000)});
      ring.push_back(overlay::from_grid(points.back()));
    }
    std::vector<BorderPiece> edges;
    add_closed(points, edges);
    overlay::arrange(edges);
    overlay::label(edges);
    for (const BorderPiece& edge : edges) {
      const Vec2 from = overlay::from_grid(edge.from), to = overlay::from_grid(edge.to);
      if ((to - from).norm() < 0.2) continue;
      // Beside the middle of the piece, but not beyond the next one.
      const Vec2 right = 0.5 * (from + to) - 0.02 * left_of((to - from).normalized());
      double nearest = 1.0;
      for (const BorderPiece& other : edges) {
        if (&other == &edge) continue;
        nearest = std::min(nearest, shapes::segment_distance(overlay::from_grid(other.from),
                                                             overlay::from_grid(other.to), right));
      }
      if (nearest < 0.06) continue;
      ++looked_at;
      ASSERT_EQ(edge.below.a, shapes::winding_number(ring, right));
      const Vec2 left = right + 0.04 * left_of((to - from).normalized());
      ASSERT_EQ(edge.below.a + edge.step.a, shapes::winding_number(ring, left));
    }
  }
  EXPECT_GT(looked_at, 1000) << "pieces";
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
