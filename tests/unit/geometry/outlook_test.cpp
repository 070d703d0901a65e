// What near walls hide, against WallIndex::sees().
#include "geometry/outlook.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"

namespace pedzone {
namespace {

using shapes::Random;

TEST(Outlook, hides_what_is_behind_a_wall_that_crosses_the_sector) {
  const WallIndex walls(std::vector<Wall>{{{-5, 2}, {5, 2}}});
  Outlook outlook;
  outlook.look(walls, {0, 0});
  EXPECT_TRUE(outlook.hides({0, 9}));
  EXPECT_TRUE(outlook.hides({-3, 9}));
  EXPECT_FALSE(outlook.hides({0, 1.9})) << "before it";
  EXPECT_FALSE(outlook.hides({0, -9})) << "on the other side";
  EXPECT_FALSE(outlook.hides({9, 1})) << "beside it";
  EXPECT_FALSE(outlook.hides({0, 0})) << "the point itself";
}

TEST(Outlook, hides_in_all_directions) {
  for (int k = 0; k < 64; ++k) {
    const double angle = k * kPi / 32.0;
    const auto turned = [&](const Vec2& v) {
      return Vec2(v.x() * unit(angle) + v.y() * left_of(unit(angle)));
    };
    const WallIndex walls(std::vector<Wall>{{turned({2, -5}), turned({2, 5})}});
    Outlook outlook;
    outlook.look(walls, {0, 0});
    for (const double aside : {-4.0, 0.0, 4.0}) {
      EXPECT_TRUE(outlook.hides(turned({9, aside}))) << angle << " " << aside;
    }
    EXPECT_FALSE(outlook.hides(turned({-9, 0}))) << angle;
  }
}

TEST(Outlook, hides_directions_between_two_others_but_not_these) {
  Outlook outlook;
  for (int k = 0; k < 64; ++k) {
    const double angle = k * kPi / 32.0 + 0.001;
    outlook.look(WallIndex(), {0, 0});
    outlook.hide_between(unit(angle), 3.0 * unit(angle + 1.0));
    for (const double inside : {0.05, 0.5, 0.95}) {
      EXPECT_TRUE(outlook.hides(0.1 * unit(angle + inside))) << angle << " " << inside;
    }
    for (const double beside : {-0.5, -1e-6, 0.0, 1e-6, 1.0, 1.5, 4.0}) {
      EXPECT_FALSE(outlook.hides(unit(angle + beside))) << angle << " " << beside;
    }
    outlook.look(WallIndex(), {0, 0});
    outlook.hide_between(unit(angle + 1.0), unit(angle));
    EXPECT_FALSE(outlook.hides(unit(angle + 2.0))) << "more than half a turn";
  }
}

TEST(Outlook, looks_round_again_from_each_point) {
  const WallIndex walls(std::vector<Wall>{{{-5, 2}, {5, 2}}});
  Outlook outlook;
  outlook.look(walls, {0, 0});
  outlook.look(walls, {0, 4});
  EXPECT_FALSE(outlook.hides({0, 9}));
  EXPECT_TRUE(outlook.hides({0, -9}));
}

/// Never says hidden of what is seen: every corner from every corner of made-up scenes, and most of
/// what is not seen is told.
TEST(Outlook, hides_nothing_that_is_seen) {
  long hidden = 0, not_seen = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Region scene = shapes::obstacle_scene(random, 120.0, 60);
    const WallIndex walls(scene);
    std::vector<Vec2> points;
    for (const Wall& wall : walls.walls()) {
      points.push_back(wall.a);
      points.push_back(0.5 * (wall.a + wall.b));
    }
    Outlook outlook;
    for (std::size_t i = 0; i < points.size(); i += 7) {
      outlook.look(walls, points[i]);
      for (const Vec2& point : points) {
        const bool seen = walls.sees(points[i], point);
        const bool is_hidden = outlook.hides(point - points[i]);
        ASSERT_FALSE(seen && is_hidden)
            << "seed " << seed << " " << points[i].transpose() << " to " << point.transpose();
        hidden += is_hidden ? 1 : 0;
        not_seen += seen ? 0 : 1;
      }
    }
  }
  EXPECT_GT(hidden, not_seen / 2);
}

TEST(Outlook, hides_no_box_that_holds_a_place_it_does_not_hide) {
  Random random(21);
  const WallIndex walls(shapes::obstacle_scene(random, 120.0, 60));
  Outlook outlook;
  int hidden = 0, boxes = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto place = [&] {
      return Vec2(shapes::uniform(random, 0.0, 120.0), shapes::uniform(random, 0.0, 120.0));
    };
    const Vec2 from = place(), low = place() - from;
    const Vec2 size(shapes::uniform(random, 0.0, 9.0), shapes::uniform(random, 0.0, 9.0));
    outlook.look(walls, from);
    bool all = true;
    for (int k = 0; k <= 20; ++k) {
      for (int j = 0; j <= 20; ++j) {
        all = all && outlook.hides(low + size.cwiseProduct(Vec2(0.05 * k, 0.05 * j)));
      }
    }
    const bool is_hidden = outlook.hides_box(low, low + size);
    ASSERT_FALSE(is_hidden && !all) << from.transpose() << ": " << low.transpose();
    hidden += is_hidden ? 1 : 0;
    boxes += all ? 1 : 0;
  }
  EXPECT_GT(hidden, boxes * 3 / 4);
  EXPECT_FALSE(outlook.hides_box({-1.0, -1.0}, {1.0, 1.0})) << "the point itself is in it";
}

TEST(Outlook, hides_nothing_that_is_seen_along_the_axes) {
  // A grid of square blocks: digits cancel, corners are in line.
  std::vector<Wall> blocks;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      const Vec2 low(10.0 * column, 10.0 * row), high = low + Vec2(6.0, 6.0);
      const Vec2 right(high.x(), low.y()), left(low.x(), high.y());
      for (const Wall& wall : {Wall{low, left}, {left, high}, {high, right}, {right, low}}) {
        blocks.push_back(wall);
      }
    }
  }
  const WallIndex walls(blocks);
  Outlook outlook;
  long hidden = 0;
  for (const Wall& from : blocks) {
    outlook.look(walls, from.a);
    for (const Wall& to : blocks) {
      const bool is_hidden = outlook.hides(to.a - from.a);
      ASSERT_FALSE(is_hidden && walls.sees(from.a, to.a))
          << from.a.transpose() << " to " << to.a.transpose();
      hidden += is_hidden ? 1 : 0;
    }
  }
  EXPECT_GT(hidden, 1000);
}

}  // namespace
}  // namespace pedzone
