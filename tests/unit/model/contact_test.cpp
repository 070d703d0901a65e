// Times of contact against walking on in small steps until something is touched.
#include <gtest/gtest.h>

#include <random>

#include "model/candidates.hpp"
#include "model/direction_kernel.hpp"
#include "model/surroundings.hpp"
#include "oracle.hpp"

namespace pedzone::test {
namespace {

/// Contacts are found one oracle step late; grazing ones lose digits in single precision.
constexpr double kTimeTolerance = 5e-3;
/// [m] by which a body may graze an obstacle without it being clear whether it touches.
constexpr double kGrazing = 2e-3;

class Contact : public testing::TestWithParam<const DirectionKernel*> {
 protected:
  Contact() {
    task_.candidates = candidates_.view();
    task_.cost = candidates_.excluded();
    walker_.speed = task_.speed = 1.34F;
    task_.horizon = 10.0F / 1.34F;
    task_.heading_cos = walker_.heading_cos;
    task_.heading_sin = walker_.heading_sin;
  }

  double number(double least, double most) {
    return least + (most - least) * std::uniform_real_distribution<double>(0.0, 1.0)(random_);
  }

  Vec2 velocity(std::size_t k) const { return 1.34 * unit(candidates_.offset(k)); }

  /// Compares every direction with the oracle, from the origin. The contact distance is bracketed,
  /// so that a graze may count or not.
  void expect_times(const DiscList& discs, const FaceList& faces, Obstacle obstacle) {
    float times[kMaxDirections];
    GetParam()->times_of(task_, discs.view(), faces.view(), 0, candidates_.padded(), times);
    for (std::size_t k = 0; k < candidates_.padded(); ++k) {
      if (candidates_.excluded()[k] != 0.0F) continue;
      Obstacle wider = obstacle, narrower = obstacle;
      wider.contact += kGrazing;
      narrower.contact -= kGrazing;
      const Vec2 v = velocity(k);
      const double soonest = time_to_contact(wider, Vec2::Zero(), v, task_.horizon);
      const double latest = time_to_contact(narrower, Vec2::Zero(), v, task_.horizon);
      EXPECT_GE(times[k], soonest - kTimeTolerance) << "direction " << k;
      EXPECT_LE(times[k], latest + kTimeTolerance) << "direction " << k;
    }
  }

  Candidates candidates_;
  DirectionTask task_;
  Walker walker_;
  std::mt19937 random_{1};
};

TEST_P(Contact, with_moving_discs) {
  for (int i = 0; i < 300; ++i) {
    const double contact = number(0.3, 1.0);
    const Vec2 at = number(contact + 0.3, 11.0) * unit(number(-kPi, kPi));
    const Vec2 v = number(0.0, 4.0) * unit(number(-kPi, kPi));
    DiscList discs;
    discs.reserve(1);
    discs.add(static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(v.x()),
              static_cast<float>(v.y()), static_cast<float>(contact), 1.34F * 1.34F);
    discs.fill_group();
    expect_times(discs, FaceList(), disc(at, v, contact));
  }
}

TEST_P(Contact, with_moving_rectangles) {
  for (int i = 0; i < 300; ++i) {
    VehicleState v = vehicle(number(1.0, 12.0) * unit(number(-kPi, kPi)), number(-kPi, kPi),
                             number(-2.0, 6.0), number(2.0, 14.0), number(0.8, 2.6));
    const double distance = distance_to(v, Vec2::Zero());
    if (distance < walker_.radius + 0.6) continue;            // room is squeezed: see below
    if (v.velocity.norm() < 0.05) v.velocity = Vec2::Zero();  // parked
    const VehicleShape shape = shape_of(v, {});
    DiscList discs;
    FaceList faces;
    add_vehicle(view_of(shape, walker_), walker_, discs, faces);
    discs.fill_group();
    faces.fill_group();
    const double room = v.velocity.norm() < 0.05 ? 0.1 : 0.25;
    expect_times(discs, faces, rectangle(v, walker_.radius + room));
  }
}

TEST_P(Contact, with_walls_from_their_walkable_side) {
  for (int i = 0; i < 300; ++i) {
    const Vec2 a = number(0.5, 9.0) * unit(number(-kPi, kPi));
    Wall wall{a, a + number(0.01, 20.0) * unit(number(-kPi, kPi))};
    if (cross(wall.b - wall.a, -a) < 0.0) std::swap(wall.a, wall.b);
    if (distance_to(wall, Vec2::Zero()) < walker_.radius + 0.02) continue;
    WallTiles tiles;
    tiles.build(std::vector<Wall>{wall}, 10.0, {});
    Surroundings around;
    around.see_walls(walker_, tiles);
    around.notice_vehicles(walker_, Senses(), {}, {}, 0.0F, [](std::size_t) { return true; });
    DirectionTask filled = task_;
    around.fill(filled);
    float times[kMaxDirections];
    GetParam()->times_of(task_, filled.still_discs, filled.still_faces, 0, candidates_.padded(),
                         times);
    for (std::size_t k = 0; k < candidates_.padded(); ++k) {
      if (candidates_.excluded()[k] != 0.0F) continue;
      const auto at = [&](double contact) {
        return time_to_contact(segment(wall, contact), Vec2::Zero(), velocity(k), task_.horizon);
      };
      EXPECT_GE(times[k], at(walker_.radius + kGrazing) - kTimeTolerance);
      EXPECT_LE(times[k], at(walker_.radius - kGrazing) + kTimeTolerance);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kernels, Contact, testing::ValuesIn([] {
                           std::vector<const DirectionKernel*> kernels{&baseline_kernel()};
                           if (has_avx2()) kernels.push_back(&avx2_kernel());
                           return kernels;
                         }()),
                         [](const auto& test) { return std::string(test.param->name); });

}  // namespace
}  // namespace pedzone::test
