// Rectangles, judged by many points of theirs.
#include "geometry/rectangle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace pedzone {
namespace {

struct Draws {
  std::mt19937 engine{7};
  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Vec2 place() { return {in(-8.0, 8.0), in(-8.0, 8.0)}; }
  Rectangle rectangle() { return {place(), unit(in(-kPi, kPi)), {in(0.2, 4.0), in(0.2, 2.0)}}; }
};

/// [m] to the nearest of a lattice of the rectangle's points.
double sampled_distance(const Rectangle& rectangle, const Vec2& point) {
  constexpr int kSteps = 60;
  double least = 1e9;
  for (int i = -kSteps; i <= kSteps; ++i) {
    for (int j = -kSteps; j <= kSteps; ++j) {
      const Vec2 share(static_cast<double>(i) / kSteps, static_cast<double>(j) / kSteps);
      const Vec2 at = rectangle.centre + share.x() * rectangle.half.x() * rectangle.axis +
                      share.y() * rectangle.half.y() * left_of(rectangle.axis);
      least = std::min(least, (at - point).norm());
    }
  }
  return least;
}

TEST(Rectangles, are_as_far_away_as_the_nearest_of_their_points) {
  Draws draws;
  for (int k = 0; k < 200; ++k) {
    const Rectangle rectangle = draws.rectangle();
    const Vec2 point = draws.place();
    EXPECT_NEAR(rectangle.distance(point), sampled_distance(rectangle, point), 0.06) << k;
  }
}

TEST(Rectangles, are_at_a_negative_distance_inside) {
  const Rectangle box{{0.0, 0.0}, {1.0, 0.0}, {2.0, 1.0}};
  EXPECT_NEAR(box.signed_distance({0.0, 0.5}), -0.5, 1e-12);
  EXPECT_NEAR(box.signed_distance({1.8, 0.5}), -0.2, 1e-12);
  EXPECT_NEAR(box.signed_distance({5.0, 0.0}), 3.0, 1e-12);
  EXPECT_NEAR(box.signed_distance({5.0, 5.0}), 5.0, 1e-12);
}

TEST(Rectangles, are_met_by_moving_discs_when_their_rims_touch) {
  const Vec2 half(2.0, 1.0);
  EXPECT_NEAR(*first_within(half, {-5.0, 0.0}, {1.0, 0.0}, 0.5, 9.0), 2.5, 1e-12);
  EXPECT_EQ(first_within(half, {-5.0, 0.0}, {1.0, 0.0}, 0.5, 2.0), std::nullopt) << "too late";
  EXPECT_EQ(first_within(half, {-5.0, 1.6}, {1.0, 0.0}, 0.5, 9.0), std::nullopt) << "goes past";
  EXPECT_EQ(*first_within(half, {0.0, 0.0}, {1.0, 0.0}, 0.5, 9.0), 0.0) << "is inside";
  // Towards a corner along the diagonal: round, not square.
  const double diagonal = std::sqrt(0.5);
  EXPECT_NEAR(*first_within(half, {4.0, 3.0}, {-diagonal, -diagonal}, 0.5, 9.0),
              2.0 / diagonal - 0.5, 1e-12);
}

TEST(Rectangles, have_a_frame_of_their_own) {
  Draws draws;
  for (int k = 0; k < 50; ++k) {
    const Rectangle rectangle = draws.rectangle();
    const Vec2 point = draws.place();
    EXPECT_LT((rectangle.out_of_frame(rectangle.into_frame(point)) - point).norm(), 1e-12);
  }
  const Rectangle north{{1.0, 2.0}, {0.0, 1.0}, {2.0, 1.0}};
  EXPECT_LT((north.into_frame({0.0, 5.0}) - Vec2(3.0, 1.0)).norm(), 1e-12) << "x ahead, y left";
}

TEST(Rectangles, are_run_through_by_lines_with_a_point_inside) {
  Draws draws;
  int through = 0, past = 0;
  for (int k = 0; k < 2000; ++k) {
    const Rectangle rectangle = draws.rectangle();
    const Vec2 a = draws.place(), b = draws.place();
    double nearest = 1e9, deepest = 1e9;  // of points of the line; deepest: < 0 well inside
    for (int i = 0; i <= 400; ++i) {
      const Vec2 local = rectangle.into_frame(a + (b - a) * (i / 400.0));
      nearest = std::min(nearest, rectangle.local_distance(local));
      deepest = std::min(deepest, (local.cwiseAbs() - rectangle.half).maxCoeff());
    }
    if (deepest < -0.01) {
      EXPECT_TRUE(runs_through(rectangle, a, b)) << k;
      ++through;
    } else if (nearest > 0.06) {  // points of the line are 0.06 m apart at most
      EXPECT_FALSE(runs_through(rectangle, a, b)) << k;
      ++past;
    }
  }
  EXPECT_GT(through, 300);
  EXPECT_GT(past, 300);
}

TEST(Rectangles, are_not_run_through_by_lines_along_or_behind_a_side) {
  const Rectangle box{{0.0, 0.0}, {1.0, 0.0}, {2.0, 1.0}};
  EXPECT_FALSE(runs_through(box, {-5.0, 1.5}, {5.0, 1.5}));
  EXPECT_TRUE(runs_through(box, {-5.0, 0.5}, {5.0, 0.5}));
  EXPECT_FALSE(runs_through(box, {-5.0, 0.0}, {-2.5, 0.0}));
  EXPECT_TRUE(runs_through(box, {-1.0, 0.0}, {1.0, 0.0}));
}

}  // namespace
}  // namespace pedzone
