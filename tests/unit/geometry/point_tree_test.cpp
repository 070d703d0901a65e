#include "geometry/point_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "shapes.hpp"

namespace pedzone {
namespace {

using shapes::Random;

std::vector<std::uint32_t> in_view(const PointTree& tree, const Outlook& outlook,
                                   const Vec2& from) {
  std::vector<std::uint32_t> found;
  tree.visit_in_view(outlook, from, [&](std::uint32_t k, const Vec2&) { found.push_back(k); });
  std::ranges::sort(found);
  return found;
}

TEST(PointTree, visits_whatever_is_not_hidden_once) {
  Random random(5);
  const WallIndex walls(shapes::obstacle_scene(random, 120.0, 60));
  std::vector<Vec2> points;
  for (const Wall& wall : walls.walls()) points.push_back(wall.a);
  points.push_back(points.front());  // the same place twice
  const PointTree tree(points);
  Outlook outlook;
  std::size_t visited = 0;
  for (const Vec2& from : points) {
    outlook.look(walls, from);
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      if (!outlook.hides(points[k] - from)) wanted.push_back(k);
    }
    ASSERT_EQ(in_view(tree, outlook, from), wanted) << from.transpose();
    visited += wanted.size();
  }
  EXPECT_LT(visited, points.size() * points.size() / 2) << "walls must hide something";
}

TEST(PointTree, tells_where_a_point_is_from_there) {
  const PointTree tree(std::vector<Vec2>{{3.0, 4.0}});
  Outlook outlook;
  outlook.look(WallIndex(), {1.0, 1.0});
  tree.visit_in_view(outlook, {1.0, 1.0}, [](std::uint32_t k, const Vec2& offset) {
    EXPECT_EQ(k, 0U);
    EXPECT_EQ(offset, Vec2(2.0, 3.0));
  });
  EXPECT_TRUE(in_view(PointTree(), outlook, {0.0, 0.0}).empty());
}

}  // namespace
}  // namespace pedzone
