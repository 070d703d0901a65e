// Boxes by place, against a look at each of them.
#include "geometry/box_tree.hpp"

#include <gmock/gmock.h>

#include <random>

namespace pedzone {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Box box(double left, double bottom, double right, double top) {
  return {Vec2(left, bottom), Vec2(right, top)};
}

TEST(BoxTree, finds_those_that_meet_a_box_its_border_included) {
  const BoxTree tree({box(0, 0, 1, 1), box(2, 0, 3, 1), box(5, 5, 6, 6)});
  EXPECT_THAT(tree.meeting(box(1, 1, 2, 2)), ElementsAre(0, 1));
  EXPECT_THAT(tree.meeting(box(3.5, 0, 4, 9)), IsEmpty());
}

TEST(BoxTree, leaves_empty_boxes_out) {
  const BoxTree tree({Box(), box(0, 0, 1, 1)});
  EXPECT_THAT(tree.meeting(box(-9, -9, 9, 9)), ElementsAre(1));
  EXPECT_THAT(tree.meeting(Box()), IsEmpty());
  EXPECT_THAT(BoxTree({}).meeting(box(0, 0, 1, 1)), IsEmpty());
}

TEST(BoxTree, finds_in_a_crowd_of_boxes_what_a_look_at_each_finds) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.0, 1000.0), side(0.0, 40.0);
  const auto any_box = [&] {
    const Vec2 corner(place(random), place(random));
    return Box(corner, corner + Vec2(side(random), side(random)));
  };
  std::vector<Box> boxes;
  for (int k = 0; k < 2000; ++k) boxes.push_back(any_box());
  const BoxTree tree(boxes);
  std::size_t found = 0;
  for (int k = 0; k < 200; ++k) {
    const Box wanted = any_box();
    std::vector<std::size_t> each;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].intersects(wanted)) each.push_back(i);
    }
    EXPECT_EQ(tree.meeting(wanted), each);
    found += each.size();
  }
  EXPECT_GT(found, 200U);
}

}  // namespace
}  // namespace pedzone
