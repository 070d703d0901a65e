#include "geometry/wall_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "allocations.hpp"
#include "shapes.hpp"

namespace pedzone {
namespace {

using shapes::box_region;
using shapes::Random;
using shapes::uniform;

Vec2 random_point(Random& random, double low, double high) {
  const double x = uniform(random, low, high);
  return {x, uniform(random, low, high)};
}

/// A point inside with some room, by trial.
Vec2 random_place(Random& random, const Region& region, double size, double room) {
  for (;;) {
    const Vec2 point = random_point(random, 0.0, size);
    if (shapes::inside_by_winding(region, point) && shapes::border_distance(region, point) > room) {
      return point;
    }
  }
}

TEST(WallIndex, has_the_walkable_side_to_the_left_of_its_walls) {
  Random random(11);
  const Region scene = shapes::obstacle_scene(random, 40.0, 15);
  const WallIndex index(scene);
  ASSERT_GT(index.walls().size(), 30u);
  for (const Wall& wall : index.walls()) {
    const Vec2 left = 0.5 * (wall.a + wall.b) + 1e-5 * left_of((wall.b - wall.a).normalized());
    EXPECT_TRUE(shapes::inside_by_winding(scene, left));
  }
}

TEST(WallIndexInside, agrees_with_winding_numbers) {
  Random random(12);
  for (int round = 0; round < 20; ++round) {
    const Region scene = shapes::obstacle_scene(random, 60.0, 40);
    const WallIndex index(scene);
    for (int i = 0; i < 2000; ++i) {
      const Vec2 point = random_point(random, -5.0, 65.0);
      if (shapes::border_distance(scene, point) < 1e-6) continue;
      ASSERT_EQ(index.inside(point), shapes::inside_by_winding(scene, point)) << point.transpose();
    }
  }
}

TEST(WallIndexInside, is_exact_on_rows_and_columns_of_corners) {
  // Rays through corners are where crossing counts go wrong.
  Random random(13);
  for (int round = 0; round < 20; ++round) {
    const Region scene = shapes::obstacle_scene(random, 40.0, 25);
    const WallIndex index(scene);
    for (const Wall& wall : index.walls()) {
      EXPECT_TRUE(index.inside(wall.a));
      EXPECT_TRUE(index.inside(0.5 * (wall.a + wall.b)));
      for (int i = 0; i < 4; ++i) {
        const double away = uniform(random, -6.0, 6.0);
        for (const Vec2& point :
             {Vec2(wall.a.x() + away, wall.a.y()), Vec2(wall.a.x(), wall.a.y() + away)}) {
          if (shapes::border_distance(scene, point) < 1e-6) continue;
          ASSERT_EQ(index.inside(point), shapes::inside_by_winding(scene, point));
        }
      }
    }
  }
}

TEST(WallIndexInside, is_true_everywhere_without_an_area_and_false_for_an_empty_one) {
  const WallIndex walls_only(std::vector<Wall>{{{0, 0}, {1, 0}}});
  EXPECT_TRUE(walls_only.inside({0.5, -3.0}));
  EXPECT_FALSE(WallIndex(Region{}).inside({0, 0}));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(WallIndex(box_region(0, 0, 1, 1)).inside({kNan, 0.5}));
}

TEST(WallIndexNear, finds_all_walls_within_reach_ascending_each_once) {
  Random random(14);
  const Region scene = shapes::obstacle_scene(random, 60.0, 40);
  const WallIndex index(scene);
  std::vector<std::uint32_t> found;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 point = random_point(random, -10.0, 70.0);
    const double reach = uniform(random, 0.0, 15.0);
    index.near(point, reach, found);
    ASSERT_TRUE(std::ranges::is_sorted(found));
    ASSERT_EQ(std::ranges::adjacent_find(found), found.end());
    for (std::uint32_t wall = 0; wall < index.walls().size(); ++wall) {
      const auto& [a, b] = index.walls()[wall];
      if (shapes::segment_distance(a, b, point) <= reach) {
        ASSERT_TRUE(std::ranges::binary_search(found, wall));
      }
    }
  }
}

TEST(WallIndexNear, allocates_nothing_once_the_list_has_grown) {
  Random random(15);
  const WallIndex index(shapes::obstacle_scene(random, 60.0, 40));
  std::vector<std::uint32_t> found;
  found.reserve(10000);
  const long before = test::allocations();
  for (int i = 0; i < 100; ++i) index.near(random_point(random, 0.0, 60.0), 20.0, found);
  EXPECT_EQ(test::allocations(), before);
}

TEST(WallIndexSlide, allocates_nothing) {
  Random random(22);
  const Region scene = shapes::obstacle_scene(random, 25.0, 20);
  const WallIndex index(scene);
  Vec2 place = random_place(random, scene, 25.0, 0.3);
  const long before = test::allocations();
  for (int i = 0; i < 10000; ++i) {
    place = index.slide(place, place + random_point(random, -0.5, 0.5), 0.3);
  }
  EXPECT_EQ(test::allocations(), before);
}

TEST(WallIndexRoom, is_the_distance_to_the_nearest_wall_up_to_the_limit) {
  Random random(16);
  const Region scene = shapes::obstacle_scene(random, 60.0, 20);
  const WallIndex index(scene);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 point = random_point(random, -10.0, 70.0);
    EXPECT_NEAR(index.room(point, 3.0), std::min(3.0, shapes::border_distance(scene, point)),
                1e-12);
  }
}

TEST(WallIndexFreeLine, agrees_with_the_distance_to_every_wall) {
  Random random(17);
  const Region scene = shapes::obstacle_scene(random, 60.0, 25);
  const WallIndex index(scene);
  int free = 0;
  std::uint32_t in_the_way = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec2 from = random_point(random, -5.0, 65.0),
               to = from + random_point(random, -20.0, 20.0);
    const double clearance = i % 2 == 0 ? 0.0 : uniform(random, 0.0, 2.0);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : index.walls()) {
      const bool meet = shapes::segments_meet(from, to, wall.a, wall.b);
      nearest = std::min({nearest, meet ? 0.0 : nearest, shapes::segment_distance(from, to, wall.a),
                          shapes::segment_distance(from, to, wall.b),
                          shapes::segment_distance(wall.a, wall.b, from),
                          shapes::segment_distance(wall.a, wall.b, to)});
    }
    if (std::abs(nearest - clearance) < 1e-6 && nearest > 0.0) continue;
    const bool expected = nearest > 0.0 && nearest >= clearance;
    free += expected;
    ASSERT_EQ(index.free_line(from, to, clearance), expected);
    ASSERT_EQ(index.free_line(from, to, clearance, in_the_way), expected);
    const WallIndex found(std::vector<Wall>{index.walls()[in_the_way]});
    ASSERT_TRUE(expected || !found.free_line(from, to, clearance));
  }
  EXPECT_GT(free, 400);
}

TEST(WallIndexSees, along_a_wall_and_from_corner_to_corner_but_not_through) {
  const WallIndex index(subtract(box_region(0, 0, 10, 10), box_region(4, 4, 6, 6)));
  EXPECT_TRUE(index.sees({0, 0}, {10, 0}));
  EXPECT_TRUE(index.sees({4, 4}, {6, 4}));
  EXPECT_TRUE(index.sees({1, 1}, {4, 6}));
  EXPECT_FALSE(index.sees({1, 5}, {9, 5}));
  EXPECT_FALSE(index.sees({5, 1}, {5, 12}));
  EXPECT_FALSE(index.sees({3, 5}, {5, 3})) << "a corner on the way counts as crossed";
}

TEST(WallIndexNearestInside, returns_a_point_that_qualifies_and_moves_others_as_little_as_needed) {
  Random random(18);
  int moved_far = 0;
  for (int round = 0; round < 10; ++round) {
    const Region scene = shapes::obstacle_scene(random, 30.0, 12);
    const WallIndex index(scene);
    // Candidates of the oracle: a fine lattice of places with room.
    constexpr double kStep = 0.1, kClearance = 0.4;
    std::vector<Vec2> lattice;
    for (double x = 0.0; x < 30.0; x += kStep) {
      for (double y = 0.0; y < 30.0; y += kStep) {
        if (index.inside({x, y}) && index.room({x, y}, 1.0) >= kClearance)
          lattice.push_back({x, y});
      }
    }
    for (int i = 0; i < 200; ++i) {
      const Vec2 point = random_point(random, -10.0, 40.0);
      const Vec2 place = index.nearest_inside(point, kClearance);
      ASSERT_TRUE(shapes::inside_by_winding(scene, place));
      const bool qualifies = shapes::inside_by_winding(scene, point) &&
                             shapes::border_distance(scene, point) >= kClearance;
      if (qualifies) {
        ASSERT_EQ(place, point);
        continue;
      }
      // A point inside may not be moved through a wall: the lattice knows nothing of that.
      if (index.inside(point)) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec2& candidate : lattice) nearest = std::min(nearest, (candidate - point).norm());
      if (shapes::border_distance(scene, place) >= kClearance - 1e-6) {
        ASSERT_LE((place - point).norm(), nearest + 1e-5);
      }
      moved_far += (place - point).norm() > 5.0;
    }
  }
  EXPECT_GT(moved_far, 50);
}

TEST(WallIndexNearestInside, is_exact_for_a_wall_a_corner_and_far_away) {
  const WallIndex index(subtract(box_region(0, 0, 10, 10), box_region(4, 4, 6, 6)));
  const double tolerance = 1e-5;
  EXPECT_LT((index.nearest_inside({2.0, 0.1}, 0.5) - Vec2(2.0, 0.5)).norm(), tolerance);
  EXPECT_LT((index.nearest_inside({0.1, 0.2}, 0.5) - Vec2(0.5, 0.5)).norm(), tolerance);
  EXPECT_LT((index.nearest_inside({-3000, -4000}, 0.5) - Vec2(0.5, 0.5)).norm(), tolerance);
  EXPECT_LT((index.nearest_inside({5.0, 4.1}, 0.5) - Vec2(5.0, 3.5)).norm(), tolerance);
  const Vec2 corner = index.nearest_inside({3.9, 3.9}, 0.5);
  EXPECT_LT((corner - (Vec2(4, 4) - 0.5 * unit(kPi / 4))).norm(), tolerance);
  EXPECT_EQ(index.nearest_inside({2.0, 2.0}, 0.5), Vec2(2.0, 2.0));
  EXPECT_EQ(index.nearest_inside({2.0, 0.0}, 0.0), Vec2(2.0, 0.0));
}

TEST(WallIndexNearestInside, takes_the_middle_of_a_narrow_passage) {
  // An alley 0.5 m wide between two houses; the squares at its ends are far.
  const Region alley = unite(std::vector<Region>{
      box_region(0, 0, 10, 10), box_region(10, 5, 30, 5.5), box_region(30, 0, 40, 10)});
  const WallIndex index(alley);
  for (const double y : {5.0, 5.05, 5.2, 5.4, 5.5, 4.0}) {
    const Vec2 place = index.nearest_inside({20.0, y}, 0.4);
    EXPECT_NEAR(place.x(), 20.0, 0.1);
    EXPECT_NEAR(place.y(), 5.25, 0.01);
  }
}

TEST(WallIndexNearestInside, does_not_move_through_a_thin_wall) {
  // Too near to a wall 5 cm thick; the other side has room sooner than this one.
  const Region rooms = subtract(box_region(0, 0, 10, 10), box_region(0.5, -1, 0.55, 11));
  const WallIndex index(rooms);
  const Vec2 place = index.nearest_inside({0.4, 5.0}, 0.3);
  EXPECT_LT(place.x(), 0.5);
  EXPECT_GT(place.x(), 0.2);
}

TEST(WallIndexNearestInside, leaves_points_alone_where_there_is_no_wall) {
  EXPECT_EQ(WallIndex().nearest_inside({1, 2}, 0.3), Vec2(1, 2));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(WallIndex(box_region(0, 0, 1, 1)).nearest_inside({kNan, 0}, 0.3).x()));
}

TEST(WallIndexSlide, keeps_the_part_of_a_move_that_runs_along_the_wall) {
  const WallIndex index(box_region(0, 0, 10, 10));
  EXPECT_EQ(index.slide({5, 5}, {6, 6}, 0.3), Vec2(6, 6));
  EXPECT_LT((index.slide({5, 0.5}, {5.5, 0.0}, 0.3) - Vec2(5.5, 0.3)).norm(), 1e-6);
  EXPECT_LT((index.slide({5, 1.0}, {5, -50.0}, 0.3) - Vec2(5, 0.3)).norm(), 1e-6);
  EXPECT_LT((index.slide({0.5, 0.5}, {-5, -5}, 0.3) - Vec2(0.3, 0.3)).norm(), 1e-6);
}

TEST(WallIndexSlide, goes_round_a_corner_that_sticks_out) {
  const WallIndex index(subtract(box_region(0, 0, 10, 10), box_region(4, -1, 6, 5)));
  Vec2 place(3.5, 5.05);
  for (int i = 0; i < 60; ++i) place = index.slide(place, place + Vec2(0.1, 0.0), 0.3);
  EXPECT_GT(place.x(), 6.0);
  EXPECT_GE(index.room(place, 1.0), 0.3 - 1e-6);
}

TEST(WallIndexSlide, gains_room_where_it_has_less_than_its_radius) {
  const WallIndex index(box_region(0, 0, 10, 10));
  for (const Vec2& start : {Vec2(5.0, 0.0), Vec2(0.01, 0.02), Vec2(0.0, 0.0), Vec2(9.9, 5.0)}) {
    Vec2 place = start;
    double room = index.room(place, 1.0);
    for (int i = 0; i < 60; ++i) {
      const Vec2 next = index.slide(place, place, 0.3);
      EXPECT_LE((next - place).norm(), 0.02 + 1e-9) << "a push is no jump";
      EXPECT_GE(index.room(next, 1.0), room - 1e-9);
      room = index.room(next, 1.0);
      place = next;
    }
    EXPECT_NEAR(room, 0.3, 1e-5) << start.transpose();
  }
}

TEST(WallIndexSlide, never_grinds_through_a_corner_narrower_than_the_disc) {
  // A wedge of 20° that opens to the right.
  const WallIndex index(
      repair({{0, 0}, {20, -20 * std::tan(kPi / 18)}, {20, 20 * std::tan(kPi / 18)}}));
  Vec2 place(10, 0.3);
  for (int i = 0; i < 300; ++i) {
    place = index.slide(place, place - Vec2(0.13, 0.01), 0.3);
    ASSERT_TRUE(index.inside(place));
  }
  EXPECT_LT(place.x(), 2.0);
}

class Passage : public testing::TestWithParam<double> {};

TEST_P(Passage, lets_a_disc_through_that_is_wider) {
  // Two squares with a passage at half height; discs come from all over the first one.
  const double half = 0.5 * GetParam();
  const WallIndex index(unite(std::vector<Region>{
      box_region(0, 0, 10, 10), box_region(9, 5 - half, 21, 5 + half), box_region(20, 0, 30, 10)}));
  Random random(19);
  for (int i = 0; i < 50; ++i) {
    Vec2 place(uniform(random, 0.4, 9.5), uniform(random, 0.4, 9.6));
    const std::vector<Vec2> aims{{9.7, 5.0}, {20.3, 5.0}, {25.0, 5.0}};
    std::size_t aim = 0;
    int steps = 0;
    for (; aim < aims.size() && steps < 2000; ++steps) {
      const Vec2 way = aims[aim] - place;
      if (way.norm() < 0.35) {
        ++aim;
        continue;
      }
      place = index.slide(place, place + std::min(0.13, way.norm()) * way.normalized(), 0.3);
      ASSERT_TRUE(index.inside(place));
    }
    EXPECT_EQ(aim, aims.size()) << "stuck at " << place.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, Passage, testing::Values(0.41, 0.45, 0.5, 0.55, 0.59, 0.61, 0.8));

TEST(WallIndexSlide, passes_between_a_wall_and_a_corner) {
  // The gap is 0.42 m wide and leads straight on, not between the two walls' normals.
  const Region tip = repair({{-5.0, 4.4}, {0.0, 3.2}, {-3.0, 2.0}});
  const WallIndex index(subtract(box_region(-10, 0, 0.42, 10), tip));
  Vec2 place(0.12, 2.0);
  int steps = 0;
  for (; place.y() < 4.0 && steps < 100; ++steps) {
    place = index.slide(place, place + 0.13 * (Vec2(0.2, 5.0) - place).normalized(), 0.3);
    ASSERT_TRUE(index.inside(place));
  }
  EXPECT_LT(steps, 100) << place.transpose();
}

/// Random walks over 10⁵ moves: never outside, never across a wall.
void walk_randomly(const WallIndex& index, const Region& scene, Random& random, double size,
                   int moves) {
  double before = 0.0;
  Vec2 place = random_place(random, scene, size, 0.01);
  double heading = 0.0, radius = 0.3, step = 0.13;
  for (int i = 0; i < moves; ++i) {
    if (i % 500 == 0) {
      place = random_place(random, scene, size, 0.001);
      radius = uniform(random, 0.05, 0.5);
      step = i % 1000 == 0 ? 0.13 : uniform(random, 0.0, 3.0);
    }
    if (i % 20 == 0) heading = uniform(random, 0.0, 2.0 * kPi);
    before = std::min(radius, index.room(place, radius));
    const Vec2 next = index.slide(place, place + step * unit(heading), radius);
    ASSERT_TRUE(next.allFinite());
    ASSERT_TRUE(shapes::inside_by_winding(scene, next) ||
                shapes::border_distance(scene, next) < 1e-9);
    ASSERT_LE((next - place).norm(), step + 0.02 + 1e-6);
    // A centre that keeps r off walls goes round their ends on an arc; its chord, a step long,
    // stays off them where r > step / 2. So the straight line tells whether it went through.
    if (before > 0.51 * (step + 0.02)) {
      for (const Wall& wall : index.walls()) {
        ASSERT_FALSE(shapes::segments_meet(place, next, wall.a, wall.b));
      }
    }
    if (before >= radius - 1e-9) {
      // Full room is only given up in a gap between walls.
      ASSERT_GE(shapes::border_distance(scene, next), std::min(radius, 0.099) - 1e-6);
    }
    place = next;
  }
}

TEST(WallIndexSlide, never_leaves_the_area_on_random_walks) {
  Random random(20);
  for (int round = 0; round < 10; ++round) {
    const Region scene = shapes::obstacle_scene(random, 25.0, 15);
    const WallIndex index(scene);
    walk_randomly(index, scene, random, 25.0, 10000);
    if (HasFatalFailure()) return;
  }
}

TEST(WallIndexSlide, never_leaves_the_area_in_a_maze_of_thin_walls) {
  // Fences 1 to 5 cm thick at all angles, some of which leave narrow gaps and acute corners.
  Random random(23);
  for (int round = 0; round < 5; ++round) {
    std::vector<Region> fences;
    for (int i = 0; i < 60; ++i) {
      const Vec2 start = random_point(random, 0.0, 25.0);
      const Vec2 end = start + uniform(random, 1.0, 8.0) * unit(uniform(random, 0.0, 2.0 * kPi));
      fences.push_back(widen({start, end}, uniform(random, 0.01, 0.05)));
    }
    const Region scene = subtract(box_region(0, 0, 25, 25), unite(fences));
    walk_randomly(WallIndex(scene), scene, random, 25.0, 10000);
    if (HasFatalFailure()) return;
  }
}

TEST(WallIndexSlide, never_leaves_an_area_far_from_the_origin) {
  // UTM coordinates: six digits less for the fraction.
  Random random(24);
  const Vec2 far(567890.0, 5678901.0);
  Region scene = shapes::obstacle_scene(random, 25.0, 15);
  const Vec2 start = far + random_place(random, scene, 25.0, 0.3);
  for (Polygon& polygon : scene) {
    for (Vec2& point : polygon.outer) point += far;
    for (Ring& hole : polygon.holes) {
      for (Vec2& point : hole) point += far;
    }
  }
  const WallIndex index(scene);
  Vec2 place = start;
  for (int i = 0; i < 20000; ++i) {
    place = index.slide(place, place + random_point(random, -0.5, 0.5), 0.3);
    ASSERT_TRUE(shapes::inside_by_winding(scene, place));
    ASSERT_TRUE(index.inside(place));
  }
  EXPECT_EQ(index.nearest_inside(start, 0.2), start);
  EXPECT_NEAR(index.room(index.nearest_inside(far - Vec2(100, 100), 0.3), 1.0), 0.3, 1e-5);
}

TEST(WallIndexSlide, stays_on_its_side_of_walls_without_an_area) {
  Random random(21);
  const std::vector<Wall> ring{
      {{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}, {{4, 4}, {0, 4}}, {{0, 4}, {0, 0}}};
  const WallIndex index(ring);
  for (const bool start_inside : {true, false}) {
    Vec2 place = start_inside ? Vec2(2, 2) : Vec2(-1, 2);
    for (int i = 0; i < 20000; ++i) {
      const Vec2 aim = place + uniform(random, 0.0, 2.0) * unit(uniform(random, 0.0, 2.0 * kPi));
      place = index.slide(place, 0.9 * (aim - Vec2(2, 2)) + Vec2(2, 2), 0.25);
      const bool in = (place.array() > 0.0).all() && (place.array() < 4.0).all();
      ASSERT_EQ(in, start_inside);
    }
  }
}

TEST(WallIndexSlide, gives_back_the_start_for_a_target_that_is_no_number) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const WallIndex index(box_region(0, 0, 10, 10));
  EXPECT_EQ(index.slide({5, 5}, {kNan, 5}, 0.3), Vec2(5, 5));
}

}  // namespace
}  // namespace pedzone
