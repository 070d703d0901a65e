#include "geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shapes.hpp"

namespace pedzone {
namespace {

using shapes::box;
using shapes::box_region;
using shapes::defect;
using shapes::Random;
using shapes::uniform;

// Corners move to the nearest grid point: an area is exact to half a grid step (here 1 mm for the
// rounding of crossings) times the length of its border.
double area_tolerance(double perimeter) { return 1e-3 * perimeter; }

TEST(Repair, keeps_a_simple_ring_and_turns_it_counter_clockwise) {
  Ring ring = box(0, 0, 4, 3);
  EXPECT_DOUBLE_EQ(area(repair(ring)), 12.0);
  std::reverse(ring.begin(), ring.end());
  const Region region = repair(ring);
  EXPECT_DOUBLE_EQ(area(region), 12.0);
  EXPECT_EQ(defect(region), "");
}

TEST(Repair, makes_two_triangles_of_a_bow_tie) {
  const Region region = repair({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  ASSERT_EQ(region.size(), 2u);
  EXPECT_DOUBLE_EQ(area(region), 8.0);
  EXPECT_EQ(defect(region), "");
}

TEST(Repair, drops_repeated_points_collinear_points_and_spikes) {
  const Region region = repair({{0, 0},
                                {0, 0},
                                {2, 0},
                                {4, 0},
                                {4, 0},
                                {4, 2},
                                {9, 2},
                                {4, 2},
                                {4, 4},
                                {0, 4},
                                {0, 7},
                                {0, 4},
                                {0, 0}});
  ASSERT_EQ(region.size(), 1u);
  EXPECT_EQ(region[0].outer.size(), 4u);
  EXPECT_DOUBLE_EQ(area(region), 16.0);
}

TEST(Repair, is_even_odd_for_a_ring_that_runs_round_twice) {
  const Region twice =
      repair({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}});
  EXPECT_DOUBLE_EQ(area(twice), 32.0);
  EXPECT_FALSE(contains(twice, {3, 3}));
  EXPECT_EQ(defect(twice), "");
}

TEST(Repair, leaves_nothing_of_rings_without_area) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(repair({}).empty());
  EXPECT_TRUE(repair({{1, 1}}).empty());
  EXPECT_TRUE(repair({{1, 1}, {2, 2}}).empty());
  EXPECT_TRUE(repair({{1, 1}, {2, 2}, {3, 3}, {2, 2}}).empty());
  EXPECT_TRUE(repair({{0, 0}, {0.09, 0}, {0.09, 0.09}, {0, 0.09}}).empty());
  EXPECT_TRUE(repair({{kNan, 0}, {1, kNan}, {1, 1}, {2, 2}}).empty());
}

TEST(Repair, of_scribbles_is_the_even_odd_region) {
  Random random(1);
  for (int round = 0; round < 300; ++round) {
    const Ring ring = shapes::scribble(random, {500, -300}, 10.0, 4 + round % 12);
    const Region region = repair(ring);
    ASSERT_EQ(defect(region), "") << round;
    for (int i = 0; i < 100; ++i) {
      const Vec2 point = Vec2(500, -300) + Vec2(uniform(random, -11, 11), uniform(random, -11, 11));
      // Slivers are left out and borders are rounded: judge only away from them.
      if (shapes::border_distance({{ring, {}}}, point) < 0.1) continue;
      ASSERT_EQ(contains(region, point), shapes::winding_number(ring, point) % 2 != 0) << round;
    }
  }
}

TEST(Overlay, of_boxes_has_the_areas_of_the_textbook) {
  const Region a = box_region(0, 0, 4, 4), b = box_region(2, 1, 6, 3);
  EXPECT_DOUBLE_EQ(area(unite(a, b)), 20.0);
  EXPECT_DOUBLE_EQ(area(intersect(a, b)), 4.0);
  EXPECT_DOUBLE_EQ(area(subtract(a, b)), 12.0);
  EXPECT_DOUBLE_EQ(area(subtract(b, a)), 4.0);
  EXPECT_TRUE(intersect(a, box_region(4, 0, 8, 4)).empty());
  EXPECT_TRUE(subtract(a, box_region(-1, -1, 5, 5)).empty());
}

TEST(Overlay, cuts_a_hole_and_keeps_an_island_in_it) {
  const Region ring = subtract(box_region(0, 0, 10, 10), box_region(2, 2, 8, 8));
  ASSERT_EQ(ring.size(), 1u);
  ASSERT_EQ(ring[0].holes.size(), 1u);
  const Region both = unite(ring, box_region(4, 4, 6, 6));
  EXPECT_EQ(both.size(), 2u);
  EXPECT_DOUBLE_EQ(area(both), 68.0);
  EXPECT_EQ(defect(both), "");
  EXPECT_TRUE(contains(both, {5, 5}));
  EXPECT_FALSE(contains(both, {3, 5}));
}

TEST(Overlay, joins_buildings_that_share_an_edge) {
  const Region row = unite(
      std::vector<Region>{box_region(0, 0, 5, 5), box_region(5, 1, 9, 4), box_region(9, 0, 12, 5)});
  ASSERT_EQ(row.size(), 1u);
  EXPECT_DOUBLE_EQ(area(row), 25.0 + 12.0 + 15.0);
  EXPECT_EQ(defect(row), "");
}

TEST(Overlay, keeps_polygons_apart_that_touch_in_a_point) {
  const Region chequered = unite(box_region(0, 0, 1, 1), box_region(1, 1, 2, 2));
  EXPECT_EQ(chequered.size(), 2u);
  EXPECT_EQ(defect(chequered), "");
}

TEST(Overlay, gives_a_hole_that_touches_the_outer_ring_in_a_point) {
  const Region region = subtract(box_region(0, 0, 4, 4), repair({{0, 2}, {2, 1}, {2, 3}}));
  ASSERT_EQ(region.size(), 1u);
  EXPECT_EQ(region[0].holes.size(), 1u);
  EXPECT_DOUBLE_EQ(area(region), 14.0);
  EXPECT_EQ(defect(region), "");
}

TEST(Overlay, survives_nearly_collinear_edges_without_losing_area) {
  // Edges a hair off each other are where overlays on floating point numbers lose polygons.
  Random random(2);
  for (int round = 0; round < 500; ++round) {
    const double angle = uniform(random, 0, kPi);
    const Vec2 d = unit(angle), n = left_of(d);
    const auto strip = [&](double from, double to) {
      const double e = uniform(random, -1e-3, 1e-3), f = uniform(random, -1e-3, 1e-3);
      return repair(
          {from * d + e * n, to * d + f * n, to * d + (3 + f) * n, from * d + (3 + e) * n});
    };
    const Region a = strip(0, 30), b = strip(uniform(random, -5, 5), uniform(random, 25, 35));
    const Region all = unite(a, b), common = intersect(a, b);
    ASSERT_EQ(defect(all), "");
    ASSERT_EQ(defect(common), "");
    ASSERT_NEAR(area(all) + area(common), area(a) + area(b), area_tolerance(140));
    ASSERT_NEAR(area(subtract(a, b)) + area(common), area(a), area_tolerance(140));
  }
}

TEST(Overlay, of_random_stars_agrees_with_membership_of_random_points) {
  Random random(3);
  for (int round = 0; round < 60; ++round) {
    const auto stars = [&] {
      std::vector<Region> all;
      for (int i = 0; i < 12; ++i) {
        const Vec2 centre(uniform(random, 0, 40), uniform(random, 0, 40));
        all.push_back(repair(shapes::star(random, centre, 12, 4 + i)));
      }
      return all;
    };
    const std::vector<Region> first = stars(), second = stars();
    const Region a = unite(first), b = unite(second);
    const Region sum = unite(a, b), both = intersect(a, b), rest = subtract(a, b);
    for (const Region* region : {&a, &b, &sum, &both, &rest}) ASSERT_EQ(defect(*region), "");
    ASSERT_NEAR(area(sum) + area(both), area(a) + area(b), area_tolerance(600));
    for (int i = 0; i < 300; ++i) {
      const Vec2 point(uniform(random, -10, 50), uniform(random, -10, 50));
      bool in_a = false, in_b = false;
      double border = 1.0;
      for (const Region& region : first) {
        in_a = in_a || shapes::inside_by_winding(region, point);
        border = std::min(border, shapes::border_distance(region, point));
      }
      for (const Region& region : second) {
        in_b = in_b || shapes::inside_by_winding(region, point);
        border = std::min(border, shapes::border_distance(region, point));
      }
      if (border < 0.1) continue;  // slivers of up to 0.01 m² may be missing there
      ASSERT_EQ(contains(a, point), in_a);
      ASSERT_EQ(contains(sum, point), in_a || in_b);
      ASSERT_EQ(contains(both, point), in_a && in_b);
      ASSERT_EQ(contains(rest, point), in_a && !in_b);
    }
  }
}

TEST(Overlay, does_not_depend_on_the_order_of_its_operands) {
  Random random(4);
  std::vector<Region> stars;
  for (int i = 0; i < 100; ++i) {
    stars.push_back(
        repair(shapes::star(random, {uniform(random, 0, 60), uniform(random, 0, 60)}, 8, 7)));
  }
  const Region forward = unite(stars);
  std::reverse(stars.begin(), stars.end());
  const Region backward = unite(stars);
  ASSERT_EQ(forward.size(), backward.size());
  for (std::size_t i = 0; i < forward.size(); ++i) {
    EXPECT_EQ(forward[i].outer, backward[i].outer);
    EXPECT_EQ(forward[i].holes, backward[i].holes);
  }
}

TEST(MakeValid, takes_polygons_that_break_the_promises) {
  // Crossed, turned the wrong way, with holes that overlap or lie outside.
  const Polygon bow_tie{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}};
  EXPECT_DOUBLE_EQ(area(make_valid({bow_tie})), 8.0);
  Polygon holes{box(0, 0, 10, 10), {box(1, 1, 5, 5), box(3, 3, 7, 7), box(20, 0, 22, 2)}};
  EXPECT_DOUBLE_EQ(area(make_valid({holes})), 100.0 - 28.0);
  const Polygon beside{box(19, -1, 23, 3), {}};
  EXPECT_DOUBLE_EQ(area(make_valid({holes, beside})), 100.0 - 28.0 + 16.0);
  std::reverse(holes.outer.begin(), holes.outer.end());
  EXPECT_EQ(defect(make_valid({holes, bow_tie})), "");
  const Region overlapping{{box(0, 0, 4, 4), {}}, {box(2, 0, 6, 4), {}}};
  EXPECT_DOUBLE_EQ(area(make_valid(overlapping)), 24.0);
}

TEST(Overlay, of_scribbles_is_valid_and_keeps_the_sum_of_areas) {
  Random random(7);
  for (int round = 0; round < 100; ++round) {
    const auto scribbles = [&] {
      Region region;
      for (int i = 0; i < 4; ++i) {
        const Vec2 centre(uniform(random, 0, 10), uniform(random, 0, 10));
        region.push_back({shapes::scribble(random, centre, 8.0, 4 + i * 2), {}});
      }
      return make_valid(region);
    };
    const Region a = scribbles(), b = scribbles();
    const Region all = unite(a, b), common = intersect(a, b), rest = subtract(a, b);
    for (const Region* region : {&all, &common, &rest}) ASSERT_EQ(defect(*region), "");
    // Slivers of up to 0.01 m² are left out, some tens of them in so many crossings.
    ASSERT_NEAR(area(all) + area(common), area(a) + area(b), 1.0);
    ASSERT_NEAR(area(rest) + area(common), area(a), 1.0);
  }
}

TEST(Overlay, of_edges_within_a_grid_step_is_valid) {
  // Many corners on few grid points: every rounding meets another corner.
  Random random(8);
  for (int round = 0; round < 300; ++round) {
    std::vector<Region> all;
    double sum = 0.0;
    for (int i = 0; i < 6; ++i) {
      Ring ring;
      for (int k = 0; k < 6; ++k) {
        const auto jitter = [&] { return 1e-3 * static_cast<double>(random() % 7); };
        ring.emplace_back(static_cast<double>(random() % 3) + jitter(),
                          static_cast<double>(random() % 3) + jitter());
      }
      all.push_back(repair(ring));
      ASSERT_EQ(defect(all.back()), "") << round;
      sum += area(all.back());
    }
    const Region region = unite(all);
    ASSERT_EQ(defect(region), "") << round;
    ASSERT_LE(area(region), sum + 0.1);
    for (const Region& part : all) ASSERT_NEAR(area(intersect(part, region)), area(part), 0.1);
  }
}

TEST(Overlay, works_far_from_the_origin) {
  // UTM coordinates: networks without netOffset have them.
  const Vec2 far(567890.0, 5678901.0);
  const auto moved = [&](const Region& region) {
    Region out = region;
    for (Vec2& point : out[0].outer) point += far;
    return out;
  };
  const Region all = unite(moved(box_region(0, 0, 4, 4)), moved(box_region(2, 1, 6, 3)));
  EXPECT_NEAR(area(all), 20.0, 1e-6);
}

TEST(Widen, of_a_straight_line_is_a_rectangle_with_flat_ends) {
  const Region region = widen({{0, 0}, {3, 0}, {3, 0}, {10, 0}}, 4.0);
  EXPECT_DOUBLE_EQ(area(region), 40.0);
  EXPECT_FALSE(contains(region, {-0.01, 0}));
  EXPECT_EQ(region[0].outer.size(), 4u);
}

TEST(Widen, joins_bends_round_without_gaps) {
  const Region region = widen({{0, 0}, {10, 0}, {10, 10}}, 4.0);
  // Two rectangles that share a 2 × 2 square, and a quarter disc.
  EXPECT_NEAR(area(region), 40.0 + 40.0 - 4.0 + kPi, 0.05);
  EXPECT_EQ(defect(region), "");
}

TEST(Widen, copes_with_hairpins_and_lines_that_are_points) {
  const Region hairpin = widen({{0, 0}, {10, 0}, {2, 0}}, 2.0);
  EXPECT_NEAR(area(hairpin), 20.0 + kPi / 2, 0.05);
  EXPECT_EQ(defect(hairpin), "");
  EXPECT_TRUE(widen({{1, 1}, {1, 1}}, 2.0).empty());
  EXPECT_TRUE(widen({}, 2.0).empty());
  EXPECT_TRUE(widen({{0, 0}, {1, 0}}, 0.0).empty());
}

TEST(Widen, holds_the_points_near_random_lines) {
  Random random(5);
  for (int round = 0; round < 100; ++round) {
    const Polyline line = shapes::scribble(random, {0, 0}, 20.0, 3 + round % 6);
    const double width = uniform(random, 0.5, 6.0);
    const Region region = widen(line, width);
    ASSERT_EQ(defect(region), "");
    for (int i = 0; i < 200; ++i) {
      const Vec2 point(uniform(random, -25, 25), uniform(random, -25, 25));
      double nearest = std::numeric_limits<double>::infinity();
      bool at_end = false;
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        nearest = std::min(nearest, shapes::segment_distance(line[k], line[k + 1], point));
      }
      for (const Vec2& end : {line.front(), line.back()}) {
        at_end = at_end || (end - point).norm() < width / 2 + 0.05;
      }
      if (at_end) continue;  // flat ends: neither a disc nor nothing
      if (nearest < width / 2 - 0.05) {
        ASSERT_TRUE(contains(region, point));
      }
      if (nearest > width / 2 + 0.05) {
        ASSERT_FALSE(contains(region, point));
      }
    }
  }
}

TEST(Grow, of_a_box_adds_its_border_and_round_corners) {
  const Region region = grow(box_region(0, 0, 10, 10), 2.0);
  EXPECT_NEAR(area(region), 100.0 + 80.0 + 4.0 * kPi, 0.2);
  EXPECT_DOUBLE_EQ(area(grow(box_region(0, 0, 10, 10), -2.0)), 36.0);
  EXPECT_TRUE(grow(box_region(0, 0, 10, 10), -5.0).empty());
  EXPECT_DOUBLE_EQ(area(grow(box_region(0, 0, 10, 10), 0.0)), 100.0);
}

TEST(Grow, mitred_has_one_corner_for_a_right_angle) {
  const Region region = grow(box_region(0, 0, 10, 10), 2.0, Corners::kMitred);
  EXPECT_EQ(region[0].outer.size(), 4u);
  EXPECT_NEAR(area(region), 196.0, 1e-9);
}

TEST(ShrinkWithin, is_what_shrinking_everything_leaves_there) {
  Random random(12);
  for (int round = 0; round < 30; ++round) {
    const Region scene = shapes::obstacle_scene(random, 40.0, 15);
    std::vector<Region> places;
    for (int i = 0; i < 5; ++i) {
      const Vec2 centre(uniform(random, 0, 40), uniform(random, 0, 40));
      places.push_back(repair(shapes::star(random, centre, uniform(random, 1.0, 8.0), 5)));
    }
    const Region where = unite(places), expected = intersect(grow(scene, -0.4), where);
    const Region found = shrink_within(scene, 0.4, where);
    ASSERT_EQ(defect(found), "");
    // Half a grid step along some hundred metres of border, and slivers left out.
    ASSERT_NEAR(area(found), area(expected), 0.1);
    ASSERT_NEAR(area(intersect(found, expected)), area(expected), 0.1);
  }
  EXPECT_TRUE(shrink_within(box_region(0, 0, 9, 9), 0.4, {}).empty());
}

class GrowRandom : public testing::TestWithParam<Corners> {};

TEST_P(GrowRandom, holds_exactly_the_points_within_the_distance) {
  Random random(6);
  for (int round = 0; round < 40; ++round) {
    const Region scene = shapes::obstacle_scene(random, 30.0, 12);
    for (const double distance : {-1.5, -0.3, 0.3, 2.0}) {
      const Region region = grow(scene, distance, GetParam());
      ASSERT_EQ(defect(region), "");
      // A mitred corner reaches up to √2 of the distance out.
      const double reach = GetParam() == Corners::kMitred ? std::sqrt(2.0) : 1.0;
      for (int i = 0; i < 200; ++i) {
        const Vec2 point(uniform(random, -4, 34), uniform(random, -4, 34));
        const double border = shapes::border_distance(scene, point);
        const double level = shapes::inside_by_winding(scene, point) ? -border : border;
        const double slack = 0.05;
        const double sure_in = std::min(distance, distance * (distance < 0 ? reach : 1.0)) - slack;
        const double sure_out = std::max(distance, distance * (distance < 0 ? 1.0 : reach)) + slack;
        // What remains of nooks narrower than slivers may be missing: not judged (slack).
        if (level < sure_in && border > 0.1) {
          ASSERT_TRUE(contains(region, point)) << level;
        }
        if (level > sure_out) {
          ASSERT_FALSE(contains(region, point)) << level;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Both, GrowRandom, testing::Values(Corners::kRound, Corners::kMitred));

}  // namespace
}  // namespace pedzone
