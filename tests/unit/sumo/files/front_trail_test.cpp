// Where the parts of a vehicle are, by where its front has been.
#include "sumo/files/front_trail.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace pedzone {
namespace {

constexpr VehicleParts kThree{10.0, 2};

/// The way: straight along x, from the origin on a circle to the left, after a quarter straight on.
Vec2 place(double way, double radius) {
  const double quarter = 0.5 * kPi * radius;
  if (way <= 0.0) return {way, 0.0};
  if (way >= quarter) return Vec2(radius, radius + way - quarter);
  return radius * Vec2(std::sin(way / radius), 1.0 - std::cos(way / radius));
}

/// [m] how far a part's ends are from where they should be, at most, all along that way.
double worst(double step, double radius, double rounding) {
  FrontTrail trail;
  double worst = 0.0;
  for (double way = -20.0; way < 100.0; way += step) {
    Vec2 front = place(way, radius);
    if (rounding > 0.0) front = (front / rounding).array().round() * rounding;
    if (trail.begun()) {
      trail.go_to(front);
    } else {
      trail.begin(front, 0.0, 30.0);
    }
    const std::vector<Rectangle> parts = trail.parts(kThree, 2.4);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Vec2 rear = place(way - 10.0 * static_cast<double>(k + 1), radius);
      const Vec2 to = place(way - 10.0 * static_cast<double>(k), radius);
      const Vec2 axis = (to - rear).normalized();
      worst = std::max({worst, (parts[k].centre + 5.0 * parts[k].axis - to).norm(),
                        10.0 * (parts[k].axis - axis).norm()});
    }
  }
  return worst;
}

TEST(FrontTrail, has_the_parts_straight_behind_at_first) {
  FrontTrail trail;
  EXPECT_FALSE(trail.begun());
  trail.begin({5.0, 0.0}, 0.0, 30.0);
  const std::vector<Rectangle> parts = trail.parts(kThree, 2.4);
  ASSERT_EQ(parts.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(parts[k].centre.isApprox(Vec2(-10.0 * k, 0.0), 1e-9)) << k;
    EXPECT_TRUE(parts[k].half.isApprox(Vec2(5.0, 1.2))) << k;
  }
}

TEST(FrontTrail, leads_the_parts_round_a_bend) {
  EXPECT_LT(worst(0.5, 25.0, 0.0), 0.01);
  EXPECT_LT(worst(5.0, 25.0, 0.0), 0.15)
      << "SUMO's steps of 1 s: a chord would be 0.13 m off alone";
  EXPECT_LT(worst(0.05, 25.0, 0.01), 0.1) << "slowly, in a file's centimetres";
}

TEST(FrontTrail, waits_with_the_vehicle) {
  FrontTrail trail;
  trail.begin({0.0, 0.0}, 0.0, 30.0);
  trail.go_to({0.4, 0.0});
  for (int i = 0; i < 100; ++i) trail.go_to({0.4, 0.0});
  EXPECT_TRUE(trail.front().isApprox(Vec2(0.4, 0.0)));
  EXPECT_TRUE(trail.parts(kThree, 2.4)[2].centre.isApprox(Vec2(-24.6, 0.0), 1e-6));
}

}  // namespace
}  // namespace pedzone
