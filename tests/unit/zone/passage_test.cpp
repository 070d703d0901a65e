// What is cut out of a large area before it is looked at.
#include "zone/passage.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"

namespace pedzone {
namespace {

Box box_of_sides(double left, double bottom, double right, double top) {
  return {Vec2(left, bottom), Vec2(right, top)};
}

TEST(Clip, has_what_an_overlay_with_the_box_has) {
  shapes::Random random(7);
  for (int scene = 0; scene < 40; ++scene) {
    const Region area = shapes::obstacle_scene(random, 30.0, 25);
    const double left = shapes::uniform(random, -5.0, 25.0);
    const double bottom = shapes::uniform(random, -5.0, 25.0);
    const double right = left + shapes::uniform(random, 1.0, 15.0);
    const double top = bottom + shapes::uniform(random, 1.0, 15.0);
    const Region expected = intersect(area, shapes::box_region(left, bottom, right, top));
    const Region found = clip(area, box_of_sides(left, bottom, right, top));
    EXPECT_NEAR(pedzone::area(found), pedzone::area(expected), 0.01) << scene;
    EXPECT_NEAR(pedzone::area(intersect(found, expected)), pedzone::area(expected), 0.01) << scene;
    EXPECT_EQ(found.size(), expected.size()) << scene;
  }
}

TEST(Clip, parts_what_hangs_together_outside_of_the_box_only) {
  // A U: its arms meet below the box.
  const Region area =
      subtract(shapes::box_region(0, 0, 30, 30), shapes::box_region(10, 10, 20, 30));
  const Region found = clip(area, box_of_sides(5, 15, 25, 25));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(pedzone::area(found), 100.0, 1e-6);
}

TEST(Clip, is_empty_in_a_hole_and_far_away) {
  const Region area = subtract(shapes::box_region(0, 0, 30, 30), shapes::box_region(5, 5, 25, 25));
  EXPECT_TRUE(clip(area, box_of_sides(10, 10, 20, 20)).empty());
  EXPECT_TRUE(clip(area, box_of_sides(40, 40, 50, 50)).empty());
}

}  // namespace
}  // namespace pedzone
