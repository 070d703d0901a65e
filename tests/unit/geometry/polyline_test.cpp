// How far a body that follows a line as a chord gets from it.
#include "geometry/polyline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pedzone {
namespace {

constexpr double kLength = 6.5;  // [m] of the chord's line

/// What chords do that begin every 5 cm, by trying.
struct Tried {
  double cut = 0.0, shorter = 0.0;  ///< [m]
};

Tried try_all(const std::vector<Vec2>& line) {
  Tried tried;
  for (double begin = 0.0; begin + kLength <= length_of(line); begin += 0.05) {
    const Vec2 rear = point_on(line, begin).point, front = point_on(line, begin + kLength).point;
    const Vec2 chord = front - rear, axis = chord.normalized();
    tried.shorter = std::max(tried.shorter, kLength - chord.norm());
    for (double at = 0.0; at <= kLength; at += 0.05) {
      const Vec2 from = point_on(line, begin + at).point - rear;
      tried.cut = std::max(tried.cut, std::abs(cross(axis, from)));
    }
  }
  return tried;
}

std::vector<Vec2> corner(double degrees) {
  return {{-20.0, 0.0}, {0.0, 0.0}, Vec2(20.0 * unit(degrees * kPi / 180.0))};
}

TEST(MostCut, bounds_what_a_chord_does_at_a_corner) {
  for (const double degrees : {1.0, 20.0, 60.0, 90.0, 110.0, 150.0}) {
    const double bound = most_cut(corner(degrees), kLength);
    const Tried tried = try_all(corner(degrees));
    EXPECT_LE(tried.cut, bound + 1e-9) << degrees;
    EXPECT_GE(tried.cut, bound - 0.05) << degrees;
    EXPECT_LE(tried.shorter, 2.0 * bound) << degrees;
  }
}

TEST(MostCut, bounds_it_in_a_long_bend_and_where_a_line_winds) {
  std::vector<Vec2> bend, winding;
  for (int k = 0; k <= 60; ++k) {
    bend.push_back(6.0 * unit(k * kPi / 60.0));
    winding.push_back({0.5 * k, std::sin(0.5 * k)});
  }
  for (const auto& line : {bend, winding}) {
    const Tried tried = try_all(line);
    EXPECT_LE(tried.cut, most_cut(line, kLength));
    EXPECT_LE(tried.shorter, 2.0 * most_cut(line, kLength));
  }
}

TEST(MostCut, is_nothing_on_a_straight_line) {
  EXPECT_NEAR(most_cut(std::vector<Vec2>{{0, 0}, {3, 3}, {3, 3}, {9, 9}}, kLength), 0.0, 1e-6);
  EXPECT_EQ(most_cut(std::vector<Vec2>{}, kLength), 0.0);
}

TEST(InsertPoint, makes_a_place_of_a_line_one_of_its_points) {
  std::vector<Vec2> line{{0, 0}, {4, 0}, {4, 0}, {4, 6}};
  insert_point(7.0, line);
  ASSERT_EQ(line.size(), 5U);
  EXPECT_TRUE(line[3].isApprox(Vec2(4, 3)));
  for (const double there : {-1.0, 0.0, 4.0, 7.0, 10.0, 11.0}) insert_point(there, line);
  EXPECT_EQ(line.size(), 5U) << "points already, or not on it";
}

TEST(StretchWithin, is_from_where_a_line_first_comes_near_to_where_it_last_is) {
  const std::vector<Vec2> turns_back{{0.0, 0.0}, {10.0, 0.0}, {10.0, 3.0}, {0.0, 3.0}};
  const auto both = stretch_within(turns_back, {4.0, 2.0}, 2.5);
  ASSERT_TRUE(both);
  EXPECT_NEAR(both->first, 4.0 - 1.5, 1e-9) << "on the farther leg";
  EXPECT_NEAR(both->last, 13.0 + 6.0 + std::sqrt(2.5 * 2.5 - 1.0), 1e-9);
  const auto one = stretch_within(turns_back, {4.0, 2.0}, 1.5);
  ASSERT_TRUE(one);
  EXPECT_NEAR(one->first, 13.0 + 6.0 - std::sqrt(1.25), 1e-9) << "on the nearer one alone";
  EXPECT_FALSE(stretch_within(turns_back, {4.0, 1.5}, 1.4));
  EXPECT_FALSE(stretch_within(turns_back, {-3.0, 0.0}, 2.0)) << "before its beginning";
  const auto end = stretch_within(turns_back, {-1.0, 0.0}, 1.5);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->first, 0.0);
}

}  // namespace
}  // namespace pedzone
