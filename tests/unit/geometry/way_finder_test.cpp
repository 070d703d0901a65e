#include "geometry/way_finder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <thread>

#include "geometry/body_room.hpp"
#include "geometry/segment.hpp"
#include "shapes.hpp"

namespace pedzone {
namespace {

using shapes::box_region;
using shapes::Random;
using shapes::uniform;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kClearance = 0.3;
// The contract's half width of the narrowest passage that counts.
constexpr double kLeast = 0.2;

double length_of(const Vec2& from, const Polyline& path) {
  double length = 0.0;
  const Vec2* last = &from;
  for (const Vec2& point : path) {
    length += (point - *last).norm();
    last = &point;
  }
  return length;
}

std::vector<Vec2> corners_of(const Region& region) {
  std::vector<Vec2> corners;
  for (const Polygon& polygon : region) {
    corners.insert(corners.end(), polygon.outer.begin(), polygon.outer.end());
    for (const Ring& hole : polygon.holes) corners.insert(corners.end(), hole.begin(), hole.end());
  }
  return corners;
}

/// Whether a segment stays in a region, by its sides against every wall: it is cut where it meets
/// one, and the middle of every part has to be inside.
bool stays_inside(const Region& region, const Vec2& from, const Vec2& to) {
  std::vector<double> cuts{0.0, 1.0};
  const WallIndex walls(region);
  for (const Wall& wall : walls.walls()) {
    const Vec2 along = wall.b - wall.a;
    const double start = cross(along, from - wall.a), end = cross(along, to - wall.a);
    if (start != end) cuts.push_back(std::clamp(start / (start - end), 0.0, 1.0));
  }
  std::ranges::sort(cuts);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i + 1] - cuts[i] < 1e-9) continue;
    const Vec2 middle = from + 0.5 * (cuts[i] + cuts[i + 1]) * (to - from);
    if (!shapes::inside_by_winding(region, middle) &&
        shapes::border_distance(region, middle) > 1e-5) {
      return false;
    }
  }
  return true;
}

/// Shortest way in a region by a full visibility graph over all its corners (no tangents, no grid).
class FullGraph {
 public:
  explicit FullGraph(const Region& region) : region_(region), points_(corners_of(region)) {
    const std::size_t count = points_.size();
    lengths_.assign(count, std::vector<double>(count, kInfinity));
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        lengths_[i][j] = lengths_[j][i] = line(points_[i], points_[j]);
      }
    }
  }

  double distance(const Vec2& from, const Vec2& to) const {
    const std::size_t count = points_.size();
    std::vector<double> best(count);
    std::vector<char> done(count, 0);
    for (std::size_t i = 0; i < count; ++i) best[i] = line(from, points_[i]);
    double result = line(from, to);
    for (;;) {
      std::size_t next = count;
      for (std::size_t i = 0; i < count; ++i) {
        if (!done[i] && (next == count || best[i] < best[next])) next = i;
      }
      if (next == count || best[next] == kInfinity) return result;
      done[next] = 1;
      result = std::min(result, best[next] + line(points_[next], to));
      for (std::size_t i = 0; i < count; ++i) {
        best[i] = std::min(best[i], best[next] + lengths_[next][i]);
      }
    }
  }

 private:
  double line(const Vec2& from, const Vec2& to) const {
    return stays_inside(region_, from, to) ? (to - from).norm() : kInfinity;
  }

  Region region_;
  std::vector<Vec2> points_;
  std::vector<std::vector<double>> lengths_;
};

/// Shortest way over a lattice whose points and lines keep `room` to the walls.
double lattice_distance(const WallIndex& walls, double size, double step, double room,
                        const Vec2& from, const Vec2& to) {
  const int count = static_cast<int>(size / step) + 1;
  const auto point = [&](int node) { return Vec2(node % count * step, node / count * step); };
  std::vector<double> best(static_cast<std::size_t>(count) * count, kInfinity);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto offer = [&](int node, const Vec2& before, double length) {
    const double total = length + (point(node) - before).norm();
    if (total >= best[node] || !walls.free_line(before, point(node), room)) return;
    best[node] = total;
    queue.emplace(total, node);
  };
  for (int node = 0; node < count * count; ++node) {
    if ((point(node) - from).norm() < 2.0 * step) offer(node, from, 0.0);
  }
  double result = kInfinity;
  while (!queue.empty()) {
    const auto [length, node] = queue.top();
    queue.pop();
    if (length > best[node] || length >= result) continue;
    if ((point(node) - to).norm() < 2.0 * step && walls.free_line(point(node), to, room)) {
      result = std::min(result, length + (point(node) - to).norm());
    }
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = node % count + dx, y = node / count + dy;
        if (x >= 0 && y >= 0 && x < count && y < count) offer(y * count + x, point(node), length);
      }
    }
  }
  return result;
}

/// A random point with at least this much room.
Vec2 random_place(Random& random, const WallIndex& index, double size, double room) {
  for (;;) {
    const double x = uniform(random, 0.0, size), y = uniform(random, 0.0, size);
    if (index.inside({x, y}) && index.room({x, y}, 2.0) > room) return {x, y};
  }
}

TEST(WayFinder, goes_straight_where_nothing_is_in_the_way) {
  const WayFinder finder(box_region(0, 0, 20, 10), kClearance);
  const auto way = finder.way({1, 1}, {19, 9});
  ASSERT_TRUE(way);
  EXPECT_EQ(*way, Polyline({Vec2(19, 9)}));
  EXPECT_DOUBLE_EQ(finder.distance({1, 1}, {19, 9}), std::hypot(18, 8));
}

TEST(WayFinder, goes_round_a_box_at_its_mitred_corners) {
  const WayFinder finder(subtract(box_region(0, 0, 20, 10), box_region(8, 4, 12, 8)), kClearance);
  const auto way = finder.way({2, 5}, {18, 5});
  ASSERT_TRUE(way);
  const Polyline expected{
      {8 - kClearance, 4 - kClearance}, {12 + kClearance, 4 - kClearance}, {18, 5}};
  ASSERT_EQ(way->size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT(((*way)[i] - expected[i]).norm(), 1e-9);
  }
}

TEST(WayFinder, finds_what_a_full_graph_over_all_corners_finds) {
  Random random(31);
  for (int round = 0; round < 25; ++round) {
    const Region scene = shapes::obstacle_scene(random, 25.0, 4 + round % 5);
    const Region room = body_room(scene, kClearance, kLeast);
    const WallIndex index(room);
    const WayFinder finder(scene, kClearance);
    const FullGraph graph(room);
    for (int i = 0; i < 15; ++i) {
      const Vec2 from = random_place(random, index, 25.0, 0.01),
                 to = random_place(random, index, 25.0, 0.01);
      const double expected = graph.distance(from, to), found = finder.distance(from, to);
      if (expected == kInfinity) {
        ASSERT_EQ(found, kInfinity);
      } else {
        ASSERT_NEAR(found, expected, 1e-4)
            << round << ": " << from.transpose() << " to " << to.transpose();
      }
    }
  }
}

TEST(WayFinder, is_never_longer_than_a_way_over_a_lattice_with_more_room) {
  Random random(32);
  int compared = 0;
  for (int round = 0; round < 8; ++round) {
    const Region scene = shapes::obstacle_scene(random, 40.0, 30);
    const WallIndex walls(scene);
    const WayFinder finder(scene, kClearance);
    for (int i = 0; i < 4; ++i) {
      // Mitred corners reach √2 clearances out: with that much room a way lies within the finder's.
      const double room = std::sqrt(2.0) * kClearance + 0.01;
      const Vec2 from = random_place(random, walls, 40.0, room),
                 to = random_place(random, walls, 40.0, room);
      const double lattice = lattice_distance(walls, 40.0, 0.4, room, from, to);
      const double found = finder.distance(from, to);
      ASSERT_GE(found, (to - from).norm() - 1e-9);
      if (lattice == kInfinity) continue;
      ASSERT_LE(found, lattice + 1e-9);
      // Eight directions cost at most 1.0824 of the straight way; the rest is for gaps between
      // the lattice's lines and for corners at which it keeps farther off.
      ASSERT_GE(found, lattice / 1.0824 - 6.0);
      ++compared;
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(WayFinder, keeps_the_clearance_or_at_least_a_body_in_narrow_places) {
  Random random(33);
  for (int round = 0; round < 10; ++round) {
    const Region scene = shapes::obstacle_scene(random, 40.0, 45);
    const WallIndex walls(scene);
    const WayFinder finder(scene, kClearance);
    for (int i = 0; i < 60; ++i) {
      const Vec2 from = random_place(random, walls, 40.0, 0.45),
                 to = random_place(random, walls, 40.0, 0.45);
      const auto way = finder.way(from, to);
      if (!way) continue;
      const Vec2* last = &from;
      for (const Vec2& point : *way) {
        // 1 cm for chords of arcs in narrow places, 2 mm for the grid.
        ASSERT_TRUE(walls.free_line(*last, point, kLeast - 0.012));
        // Where nothing narrow is near, the clearance itself holds: a full disc fits beside.
        last = &point;
      }
      ASSERT_EQ(way->back(), to);
      ASSERT_EQ(length_of(from, *way), finder.distance(from, to));
    }
  }
}

TEST(WayFinder, keeps_the_whole_clearance_where_there_is_no_narrow_place) {
  // Pillars 3 m apart.
  std::vector<Region> pillars;
  for (int x = 2; x < 30; x += 4) {
    for (int y = 2; y < 30; y += 4) pillars.push_back(box_region(x, y, x + 1, y + 1));
  }
  const Region scene = subtract(box_region(0, 0, 31, 31), unite(pillars));
  const WallIndex walls(scene);
  const WayFinder finder(scene, kClearance);
  Random random(34);
  for (int i = 0; i < 300; ++i) {
    const Vec2 from = random_place(random, walls, 31.0, 0.45),
               to = random_place(random, walls, 31.0, 0.45);
    const auto way = finder.way(from, to);
    ASSERT_TRUE(way);
    const Vec2* last = &from;
    for (const Vec2& point : *way) {
      ASSERT_TRUE(walls.free_line(*last, point, kClearance - 0.001));
      last = &point;
    }
  }
}

class Alley : public testing::TestWithParam<double> {};

TEST_P(Alley, is_passable_when_wider_than_a_body) {
  const double half = 0.5 * GetParam();
  const WayFinder finder(
      unite(std::vector<Region>{box_region(0, 0, 10, 10), box_region(9, 5 - half, 21, 5 + half),
                                box_region(20, 0, 30, 10)}),
      kClearance);
  const auto way = finder.way({2, 2}, {28, 2});
  ASSERT_EQ(way.has_value(), GetParam() > 0.4);
  if (way) {
    EXPECT_LT(finder.distance({2, 2}, {28, 2}), 28.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, Alley,
                         testing::Values(0.3, 0.39, 0.41, 0.45, 0.5, 0.59, 0.61, 0.7, 0.84, 0.9,
                                         2.0));

TEST(WayFinder, passes_gaps_between_corners_and_between_a_tip_and_a_wall) {
  for (const double gap : {0.42, 0.5, 0.59, 0.65, 0.8}) {
    const double e = gap / std::sqrt(2.0);
    // Two blocks fill two opposite quarters and leave a gap between their corners.
    const Region diagonal =
        subtract(box_region(0, 0, 20, 20),
                 unite(box_region(-1, -1, 10, 10), box_region(10 + e, 10 + e, 21, 21)));
    EXPECT_TRUE(WayFinder(diagonal, kClearance).way({2, 18}, {18, 2})) << gap;
    const Region tip = subtract(box_region(0, 0, 20, 10), repair({{8, 11}, {12, 11}, {10, gap}}));
    EXPECT_TRUE(WayFinder(tip, kClearance).way({2, 5}, {18, 5})) << gap;
  }
  const Region closed = subtract(box_region(0, 0, 20, 10), repair({{8, 11}, {12, 11}, {10, 0.35}}));
  EXPECT_FALSE(WayFinder(closed, kClearance).way({2, 5}, {18, 5}));
}

TEST(WayFinder, connects_what_a_body_of_40_cm_can_reach_and_nothing_else) {
  Random random(35);
  int narrow = 0;
  for (int round = 0; round < 15; ++round) {
    const Region scene = shapes::obstacle_scene(random, 40.0, 110);
    const WayFinder finder(scene, kClearance);
    // 1 cm either way for the chords of round corners.
    const Region sure = grow(scene, -kLeast - 0.012), possible = grow(scene, -kLeast + 0.012);
    const Region roomy = grow(scene, -kClearance);
    const auto part = [](const Region& region, const Vec2& point) {
      for (std::size_t i = 0; i < region.size(); ++i) {
        if (contains({region[i]}, point)) return static_cast<int>(i);
      }
      return -1;
    };
    const WallIndex walls(scene);
    for (int i = 0; i < 150; ++i) {
      const Vec2 from = random_place(random, walls, 40.0, 0.45),
                 to = random_place(random, walls, 40.0, 0.45);
      const bool found = finder.way(from, to).has_value();
      if (part(sure, from) == part(sure, to)) {
        ASSERT_TRUE(found) << round << ": " << from.transpose() << " to " << to.transpose();
        narrow += part(roomy, from) != part(roomy, to);
      }
      if (part(possible, from) != part(possible, to)) {
        ASSERT_FALSE(found);
      }
    }
  }
  EXPECT_GT(narrow, 20) << "the scenes have to have narrow passages that matter";
}

TEST(WayFinder, knows_whether_there_is_a_way_without_looking_for_it) {
  Random random(37);
  int apart = 0, joined = 0;
  for (int round = 0; round < 15; ++round) {
    const Region scene = shapes::obstacle_scene(random, 40.0, 110);
    const WayFinder finder(scene, kClearance);
    for (int i = 0; i < 100; ++i) {
      // Anywhere: in obstacles and outside, too.
      const Vec2 from(uniform(random, -5.0, 45.0), uniform(random, -5.0, 45.0)),
          to(uniform(random, -5.0, 45.0), uniform(random, -5.0, 45.0));
      const bool found = finder.way(from, to).has_value();
      ASSERT_EQ(finder.has_way(from, to), found) << from.transpose() << " to " << to.transpose();
      ++(found ? joined : apart);
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(joined, 50);
}

TEST(WayFinder, leads_to_a_line_by_the_shortest_of_the_ways_to_its_points) {
  Random random(38);
  int compared = 0, between = 0;
  for (int round = 0; round < 40; ++round) {
    const Region scene = shapes::obstacle_scene(random, 40.0, 30);
    const WallIndex walls(scene);
    const WayFinder finder(scene, kClearance);
    for (int i = 0; i < 20; ++i) {
      const Vec2 from = random_place(random, walls, 40.0, 0.45),
                 a = random_place(random, walls, 40.0, 0.45),
                 b = a + 8.0 * Vec2(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
      if (!walls.inside(b) || !walls.free_line(a, b, 0.45)) continue;
      const auto way = finder.way_to_line(from, a, b);
      double least = kInfinity;
      for (int k = 0; k <= 40; ++k) {
        least = std::min(least, finder.distance(from, a + k / 40.0 * (b - a)));
      }
      ASSERT_EQ(way.has_value(), least < kInfinity);
      if (!way) continue;
      const Vec2 end = way->back();
      ASSERT_LT((nearest_on(a, b, end) - end).norm(), 1e-9);
      // No longer than to any of 41 points, and as long as the way to where it ends.
      ASSERT_LE(length_of(from, *way), least + 1e-6);
      ASSERT_NEAR(length_of(from, *way), finder.distance(from, end), 1e-6);
      ++compared;
      between += way->size() > 1 && (end - a).norm() > 0.1 && (end - b).norm() > 0.1;
    }
  }
  EXPECT_GT(compared, 200);
  EXPECT_GT(between, 10) << "the ways have to turn and end within lines, too";
}

TEST(WayFinder, finds_nothing_between_separate_areas) {
  const WayFinder finder(unite(box_region(0, 0, 5, 5), box_region(8, 0, 13, 5)), kClearance);
  EXPECT_FALSE(finder.way({1, 1}, {10, 1}));
  EXPECT_EQ(finder.distance({1, 1}, {10, 1}), kInfinity);
  EXPECT_TRUE(finder.way({1, 1}, {4, 4}));
}

TEST(WayFinder, finds_nothing_without_an_area_or_with_no_numbers) {
  EXPECT_FALSE(WayFinder().way({1, 1}, {2, 2}));
  EXPECT_FALSE(WayFinder(Region{}, kClearance).way({1, 1}, {2, 2}));
  const WayFinder finder(box_region(0, 0, 5, 5), kClearance);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(finder.way({kNan, 1}, {2, 2}));
}

TEST(WayFinder, moves_ends_without_room_to_the_nearest_place_that_has_it) {
  const WayFinder finder(subtract(box_region(0, 0, 20, 10), box_region(8, 4, 12, 8)), kClearance);
  const auto way = finder.way({0.1, 5}, {10, 4.5});
  ASSERT_TRUE(way);
  EXPECT_LT((way->back() - Vec2(10, 4 - kClearance)).norm(), 1e-3);
  const auto from_block = finder.way({10, 7.5}, {10, 9});
  ASSERT_TRUE(from_block);
  EXPECT_LT((from_block->front() - Vec2(10, 8 + kClearance)).norm(), 1e-3);
  EXPECT_TRUE(finder.way({-500, 5}, {500, 5}));
}

TEST(WayFinder, leads_along_a_wall_from_a_place_right_at_it) {
  const Region scene = subtract(box_region(0, 0, 20, 10), box_region(8, 0, 12, 8));
  const WallIndex walls(scene);
  const WayFinder finder(scene, kClearance);
  for (const Vec2& from : {Vec2(7.99, 0.01), Vec2(8.0, 4.0), Vec2(7.95, 8.02), Vec2(8.0, 8.0)}) {
    const auto way = finder.way(from, {13, 1});
    ASSERT_TRUE(way);
    const Vec2* last = &from;
    for (const Vec2& point : *way) {
      EXPECT_TRUE(walls.sees(*last, point));
      last = &point;
    }
  }
}

TEST(WayFinder, takes_the_same_length_both_ways_and_in_a_turned_scene) {
  Random random(36);
  const auto turned = [](const Vec2& p) { return left_of(p); };
  for (int round = 0; round < 5; ++round) {
    const Region scene = shapes::obstacle_scene(random, 40.0, 30);
    Region other = scene;
    for (Polygon& polygon : other) {
      for (Vec2& point : polygon.outer) point = turned(point);
      for (Ring& hole : polygon.holes) {
        for (Vec2& point : hole) point = turned(point);
      }
    }
    const WallIndex walls(scene);
    const WayFinder finder(scene, kClearance), turned_finder(other, kClearance);
    for (int i = 0; i < 30; ++i) {
      const Vec2 from = random_place(random, walls, 40.0, 0.45),
                 to = random_place(random, walls, 40.0, 0.45);
      const double there = finder.distance(from, to);
      if (there == kInfinity) {
        EXPECT_EQ(finder.distance(to, from), kInfinity);
        continue;
      }
      EXPECT_NEAR(finder.distance(to, from), there, 1e-9);
      // Corners are rounded to the grid: the same way to some millimetres.
      EXPECT_NEAR(turned_finder.distance(turned(from), turned(to)), there, 0.02);
    }
  }
}

TEST(WayFinder, gives_the_same_ways_to_many_threads) {
  Random random(37);
  const Region scene = shapes::obstacle_scene(random, 40.0, 30);
  const WallIndex walls(scene);
  const WayFinder finder(scene, kClearance);
  std::vector<std::pair<Vec2, Vec2>> trips;
  for (int i = 0; i < 100; ++i) {
    const Vec2 from = random_place(random, walls, 40.0, 0.1);
    trips.emplace_back(from, random_place(random, walls, 40.0, 0.1));
  }
  const auto all_ways = [&] {
    std::vector<std::optional<Polyline>> ways;
    for (const auto& [from, to] : trips) ways.push_back(finder.way(from, to));
    return ways;
  };
  const auto expected = all_ways();
  std::vector<std::vector<std::optional<Polyline>>> found(4);
  std::vector<std::thread> threads;
  for (auto& ways : found) threads.emplace_back([&] { ways = all_ways(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& ways : found) EXPECT_EQ(ways, expected);
}

}  // namespace
}  // namespace pedzone
