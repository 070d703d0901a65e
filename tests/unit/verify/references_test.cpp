#include "verify/references.hpp"

#include <gtest/gtest.h>

namespace pedzone::verify {
namespace {

TEST(Weidmann, has_the_published_speeds) {
  EXPECT_NEAR(weidmann_speed(1.0), 1.06, 0.005);
  EXPECT_NEAR(weidmann_speed(2.0), 0.61, 0.005);
  EXPECT_NEAR(weidmann_speed(3.0), 0.33, 0.005);
  EXPECT_NEAR(1.75 * weidmann_speed(1.75), kWeidmannFlow, 0.005);
}

TEST(Bands, hold_what_they_are_made_of) {
  for (const Point& point : juelich_one_way()) {
    EXPECT_LT(one_way_band(point.x).low, point.y);
    EXPECT_GT(one_way_band(point.x).high, point.y);
  }
  for (double density = 0.5; density <= 3.5; density += 0.1) {
    EXPECT_LT(one_way_band(density).low, weidmann_speed(density));
    EXPECT_GT(one_way_band(density).high, weidmann_speed(density));
  }
  for (const Point& point : juelich_two_ways()) {
    EXPECT_NEAR(two_way_band(point.x).low, 0.85 * point.y, 1e-9);
    EXPECT_NEAR(two_way_band(point.x).high, 1.15 * point.y, 1e-9);
  }
}

TEST(Interpolated, is_exact_at_points_and_ends_with_them) {
  const Points points{{1.0, 2.0}, {2.0, 4.0}};
  EXPECT_DOUBLE_EQ(*interpolated(points, 1.5), 3.0);
  EXPECT_DOUBLE_EQ(*interpolated(points, 2.0), 4.0);
  EXPECT_DOUBLE_EQ(*interpolated(points, 0.1), 2.0);
  EXPECT_FALSE(interpolated(points, 2.1));
}

}  // namespace
}  // namespace pedzone::verify
