#include "zone/lane_geometry.hpp"

#include <gmock/gmock.h>

namespace pedzone {
namespace {

const Polyline kBent{{0, 0}, {10, 0}, {10, 10}};

TEST(PointOn, follows_the_bend) {
  EXPECT_TRUE(point_on(kBent, 15.0).point.isApprox(Vec2(10, 5)));
  EXPECT_TRUE(point_on(kBent, 15.0).direction.isApprox(Vec2(0, 1)));
}

TEST(PointOn, stays_on_the_line) {
  EXPECT_TRUE(point_on(kBent, 99.0).point.isApprox(Vec2(10, 10)));
  EXPECT_NEAR(point_on(kBent, -5.0).point.norm(), 0.0, 1e-12);
}

TEST(ProjectOn, is_positive_to_the_left) {
  const LineProjection left = project_on(kBent, {4, 2});
  EXPECT_NEAR(left.offset, 4.0, 1e-12);
  EXPECT_NEAR(left.lateral, 2.0, 1e-12);
  EXPECT_NEAR(project_on(kBent, {4, -2}).lateral, -2.0, 1e-12);
}

TEST(Lane, positions_are_scaled_to_the_shape) {
  Lane lane;
  lane.shape = {{0, 0}, {20, 0}};
  lane.length = 10.0;
  EXPECT_NEAR(point_on_lane(lane, 5.0).point.x(), 10.0, 1e-12);
  EXPECT_NEAR(project_on_lane(lane, {10, 0}).offset, 5.0, 1e-12);
}

}  // namespace
}  // namespace pedzone
