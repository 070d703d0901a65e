#include "geometry/near_points.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/random.hpp"

namespace pedzone::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(NearPoints, are_those_that_a_look_at_all_finds) {
  std::vector<Vec2> points;
  for (std::uint64_t k = 0; k < 500; ++k) {
    points.emplace_back(100.0 * random_uniform(3, k, 1, Purpose::kPlacement),
                        100.0 * random_uniform(3, k, 2, Purpose::kPlacement));
  }
  const NearPoints near(points);
  for (const double reach : {0.0, 0.5, 7.0, 40.0, 200.0}) {
    for (const Vec2& place : {points[7], Vec2(50.0, 50.0), Vec2(-3.0, 90.0), Vec2(400.0, 0.0)}) {
      std::vector<std::uint32_t> wanted;
      for (std::uint32_t k = 0; k < points.size(); ++k) {
        if ((points[k] - place).cwiseAbs().maxCoeff() <= reach) wanted.push_back(k);
      }
      EXPECT_EQ(near.within(place, reach), wanted) << reach << " at " << place.transpose();
    }
  }
}

TEST(NearPoints, include_the_border_and_forget_those_before) {
  NearPoints near(std::vector<Vec2>{{1.0, 0.0}, {0.0, 2.0}, {-1.0, -1.0}});
  EXPECT_THAT(near.within({0.0, 0.0}, 1.0), ElementsAre(0, 2));
  near.build(std::vector<Vec2>{{5.0, 5.0}});
  EXPECT_THAT(near.within({0.0, 0.0}, 1.0), IsEmpty());
  EXPECT_THAT(NearPoints().within({0.0, 0.0}, 1.0), IsEmpty());
}

}  // namespace
}  // namespace pedzone::test
