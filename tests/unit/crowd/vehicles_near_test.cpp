// Which vehicles are listed for a place, and whether a vehicle comes there: against looking at
// every vehicle, and at every 5 cm of its way.
#include "crowd/state/vehicles_near.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "crowd/sense/side_room.hpp"
#include "crowd/sense/vehicle_motion.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

double random_in(double low, double high, std::uint64_t key, std::uint64_t what) {
  return low + (high - low) * random_uniform(7, key, what, Purpose::kImpulse);
}

/// Vehicles all over a town, that drive straight on or turn.
class Town : public ::testing::Test {
 protected:
  Town() {
    ways_.resize(300);
    for (std::uint64_t k = 0; k < ways_.size(); ++k) {
      const double heading = random_in(-kPi, kPi, k, 1), length = random_in(2.0, 18.0, k, 2);
      const Vec2 rear(random_in(-300.0, 300.0, k, 3), random_in(-300.0, 300.0, k, 4));
      const Vec2 front = rear + length * unit(heading);
      VehicleState vehicle =
          vehicle_at(0.5 * (rear + front), heading, random_in(0.0, 14.0, k, 5), length, 2.0);
      const double turn = random_in(-2.5, 2.5, k, 6);
      ways_[k] = {rear, front, front + 2.0 * unit(heading + 0.5 * turn),
                  front + 2.0 * unit(heading + 0.5 * turn) + 60.0 * unit(heading + turn)};
      if (k % 3 != 0) vehicle.way = ways_[k];
      vehicle.forwards = true;
      vehicles_.push_back(vehicle);
    }
    for (std::uint64_t k = 0; k < 200; ++k) {
      persons_.x.push_back(random_in(-250.0, 250.0, k, 7));
      persons_.y.push_back(random_in(-250.0, 250.0, k, 8));
    }
    near_.build(vehicles_, persons_, 1.0);
  }

  Vec2 person(std::size_t i) const { return {persons_.x[i], persons_.y[i]}; }
  bool lists(const Vec2& point, std::uint32_t v) const {
    return std::ranges::binary_search(near_.at(point), v);
  }

  std::vector<Polyline> ways_;
  std::vector<VehicleState> vehicles_;
  Persons persons_;
  VehiclesNear near_;
};

TEST_F(Town, lists_who_is_near_within_the_step_or_soon_after) {
  std::size_t listed = 0;
  for (std::size_t i = 0; i < persons_.x.size(); ++i) {
    const auto list = near_.at(person(i));
    listed += list.size();
    EXPECT_TRUE(std::ranges::is_sorted(list));
    for (std::uint32_t v = 0; v < vehicles_.size(); ++v) {
      for (const double time : {0.0, 0.5, 1.0, 2.0, 4.0}) {  // 3 s ahead of the end of a step
        const Rectangle body = rectangle_of(moved_on(vehicles_[v], time));
        if (body.distance(person(i)) > VehiclesNear::kReach) continue;
        ASSERT_TRUE(lists(person(i), v)) << v << " in " << time << " s";
      }
    }
  }
  EXPECT_LT(listed, persons_.x.size() * vehicles_.size() / 5) << "most are near nobody";
}

TEST_F(Town, lists_who_claims_room_there) {
  VehicleState& vehicle = vehicles_[1];
  vehicle.centre = Vec2(-100.0, 100.0);
  vehicle.velocity = Vec2::Zero();
  vehicle.claim = 50.0;
  near_.build(vehicles_, persons_, 1.0);
  const Vec2 ahead = unit(vehicle.heading);
  EXPECT_TRUE(lists(vehicle.centre + ahead * (0.5 * vehicle.length + vehicle.claim), 1));
  EXPECT_FALSE(lists(vehicle.centre + ahead * 140.0, 1));
  EXPECT_EQ(near_.at(Vec2(0.0, 0.0), VehiclesNear::kReach + 0.1).size(), vehicles_.size());
  EXPECT_EQ(near_.at(Vec2(0.0, 0.0), 1.0, VehiclesNear::kAhead + 0.1).size(), vehicles_.size());
}

TEST_F(Town, lists_who_may_drive_off_as_far_in_a_long_step) {
  VehicleState& vehicle = vehicles_[1];
  vehicle.centre = Vec2(-100.0, 100.0);
  vehicle.velocity = Vec2::Zero();
  const Vec2 there = vehicle.centre + unit(vehicle.heading) * 100.0;
  near_.build(vehicles_, persons_, 5.0);
  EXPECT_FALSE(lists(there, 1));
  vehicle.starts = 100.0;
  near_.build(vehicles_, persons_, 5.0);
  EXPECT_TRUE(lists(there, 1));
}

TEST_F(Town, lists_all_where_nobody_was) {
  EXPECT_EQ(near_.at(Vec2(900.0, 0.0)).size(), vehicles_.size());
  near_.build(vehicles_, {}, 1.0);
  EXPECT_EQ(near_.at(person(0)).size(), vehicles_.size());
  near_.build({}, persons_, 1.0);
  EXPECT_TRUE(near_.at(person(0)).empty());
}

TEST_F(Town, tells_who_comes_near) {
  int near = 0, far = 0;
  for (std::uint64_t k = 0; k < 20'000; ++k) {
    const VehicleState& vehicle = vehicles_[k % vehicles_.size()];
    const Vec2 point =
        vehicle.centre + Vec2(random_in(-15.0, 15.0, k, 9), random_in(-15.0, 15.0, k, 10));
    double least = distance_to(vehicle, point);
    if (!vehicle.way.empty()) {
      const double at = project_on(vehicle.way, point).offset;
      const double last = at + vehicle.length;
      for (double way = std::max(0.0, at - 2.0 * vehicle.length); way <= last; way += 0.05) {
        least = std::min(least, body_on_way(vehicle, way).distance(point));
      }
    }
    // Between two places that are looked at it may come a little nearer.
    if (comes_within(vehicle, point, 0.4)) {
      ++near;
      ASSERT_LT(least, 0.45) << k;
    } else {
      ++far;
      ASSERT_GT(least, 0.25) << k;
    }
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(far, 1000);
}

}  // namespace
}  // namespace pedzone::test
