#include "verify/voronoi.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "verify/ground.hpp"
#include "zone/shapes.hpp"

namespace pedzone::verify {
namespace {

constexpr double kExact = 1e-9;  // [m²] cells of a convex area are cut without a grid
constexpr double kGrid = 5e-3;   // [m²] other areas are cut on whole millimetres

std::vector<Vec2> random_points(const Region& region, std::size_t count, std::uint64_t seed) {
  const Box extent = box_of(region);
  std::vector<Vec2> points;
  for (std::uint64_t draw = 0; points.size() < count; ++draw) {
    const Vec2 share(random_uniform(seed, draw, 0, Purpose::kPlacement),
                     random_uniform(seed, draw, 1, Purpose::kPlacement));
    const Vec2 point = extent.min() + share.cwiseProduct(extent.sizes());
    if (contains(region, point)) points.push_back(point);
  }
  return points;
}

double sum_of_areas(const VoronoiCells& cells) {
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) sum += cells.area(i);
  return sum;
}

TEST(Voronoi, one_person_has_the_whole_room) {
  const VoronoiCells cells(repair(box(0, 0, 5, 4)), std::vector<Vec2>{{1, 1}});
  EXPECT_NEAR(cells.area(0), 20.0, kExact);
}

TEST(Voronoi, nobody_makes_no_density) {
  const VoronoiCells cells(repair(box(0, 0, 5, 4)), std::vector<Vec2>{});
  EXPECT_EQ(cells.density(box(1, 1, 2, 2)), 0.0);
  EXPECT_FALSE(cells.mean(std::vector<double>{}, box(1, 1, 2, 2)));
}

TEST(Voronoi, two_people_share_by_the_line_in_the_middle) {
  // Middle between x = 1 and x = 2: 1.5 m and 4.5 m of a room 6 m long and 2 m wide.
  const VoronoiCells cells(repair(box(0, 0, 6, 2)), std::vector<Vec2>{{1, 1}, {2, 1}});
  EXPECT_NEAR(cells.area(0), 3.0, kExact);
  EXPECT_NEAR(cells.area(1), 9.0, kExact);
  // In x of 1 to 2: half at 1/3, half at 1/9 persons/m².
  EXPECT_NEAR(cells.density(box(1, 0, 2, 2)), 0.5 / 3.0 + 0.5 / 9.0, 1e-12);
  EXPECT_NEAR(*cells.mean(std::vector<double>{1.0, 3.0}, box(1, 0, 2, 2)), 2.0, 1e-12);
  EXPECT_NEAR(*cells.mean(std::vector<double>{1.0, 3.0}, box(0, 0, 6, 2)), 2.5, 1e-12);
}

TEST(Voronoi, a_grid_of_people_has_square_cells) {
  std::vector<Vec2> points;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) points.emplace_back(0.5 + x, 0.5 + y);
  }
  const VoronoiCells cells(repair(box(0, 0, 6, 6)), points);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(cells.area(i), 1.0, kExact) << i;
  EXPECT_NEAR(cells.density(box(1.3, 1.7, 4.2, 3.1)), 1.0, 1e-9);
}

TEST(Voronoi, cells_sum_up_to_the_area) {
  const Region room = repair(box(-3, 0, 7, 5));
  const Region corner = joined({box(0, 0, 8, 2), box(6, 0, 8, 8)});
  const Region pillar = subtract(room, repair(box(1, 2, 2, 3)));
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const std::size_t count : {1, 2, 3, 40}) {
      const VoronoiCells cells(room, random_points(room, count, seed));
      EXPECT_NEAR(sum_of_areas(cells), 50.0, 1e-7) << seed << " " << count;
    }
    // Walls take away the parts of cells that nobody stands in, never more than that.
    for (const Region& region : {corner, pillar}) {
      const VoronoiCells cells(region, random_points(region, 60, seed));
      EXPECT_LE(sum_of_areas(cells), area(region) + kGrid * 60);
      EXPECT_GE(sum_of_areas(cells), 0.9 * area(region));
    }
  }
}

TEST(Voronoi, a_cell_does_not_reach_behind_a_wall) {
  // A wall from y = 0 to 3 at x = 2; the person's cell goes round it, the other room is nobody's.
  const Region rooms = subtract(repair(box(0, 0, 4, 3)), repair(box(1.9, 0, 2.1, 3)));
  const VoronoiCells cells(rooms, std::vector<Vec2>{{1, 1}});
  EXPECT_NEAR(cells.area(0), 1.9 * 3.0, kGrid);
}

TEST(Voronoi, a_cell_may_end_at_a_distance) {
  const VoronoiCells cells(repair(box(0, 0, 20, 20)), std::vector<Vec2>{{10, 10}}, 1.0);
  // A polygon of 16 sides round a circle of 1 m.
  EXPECT_NEAR(cells.area(0), 16.0 * std::tan(kPi / 16.0), 1e-9);
}

TEST(Voronoi, whoever_stands_outside_or_on_somebody_has_no_part_of_another) {
  const Region room = repair(box(0, 0, 4, 4));
  const VoronoiCells cells(room, std::vector<Vec2>{{1, 2}, {3, 2}, {9, 9}});
  EXPECT_EQ(cells.area(2), 0.0);
  EXPECT_NEAR(cells.area(0) + cells.area(1), 16.0, 1e-9);
}

TEST(Voronoi, is_the_same_turned) {
  const Region room = repair(box(0, 0, 6, 4));
  const std::vector<Vec2> points = random_points(room, 20, 3);
  const VoronoiCells cells(room, points);
  for (const double angle : {0.3, 1.1, 2.9}) {
    std::vector<Vec2> moved;
    for (const Vec2& point : points) moved.push_back(turned(point, angle));
    Ring area = box(1, 1, 4, 3);
    for (Vec2& corner : area) corner = turned(corner, angle);
    const VoronoiCells other(turned(room, angle), moved);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(other.area(i), cells.area(i), 1e-9);
    EXPECT_NEAR(other.density(area), cells.density(box(1, 1, 4, 3)), 1e-9);
  }
}

TEST(LeftPart, cuts_a_square) {
  const Ring half = left_part(box(0, 0, 2, 2), {1, 0}, {1, 1});
  EXPECT_NEAR(signed_area(half), 2.0, 1e-12);
  EXPECT_NEAR(signed_area(left_part(box(0, 0, 2, 2), {3, 0}, {3, 1})), 4.0, 1e-12);
  EXPECT_TRUE(left_part(box(0, 0, 2, 2), {-1, 0}, {-1, 1}).empty());
}

}  // namespace
}  // namespace pedzone::verify
