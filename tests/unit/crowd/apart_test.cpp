// Vehicles behind a kerb: who keeps off people's ground is not given way to.
#include "crowd/sense/apart.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "scene.hpp"

namespace pedzone::test {
namespace {

/// A footway of 2 m beside a lane of 3.2 m, and one along the crossroad at x = 60.
Zone footways() { return zone_of(Ring{{0, 0}, {58, 0}, {58, -20}, {60, -20}, {60, 2}, {0, 2}}); }

TEST(Apart, is_who_drives_beside_people) {
  const Zone zone = footways();
  EXPECT_TRUE(keeps_apart(zone.walls, vehicle_at({10, 3.6}, 0.0, 8.0)));
  EXPECT_TRUE(keeps_apart(zone.walls, vehicle_at({10, 3.6}, kPi, 8.0)));
  EXPECT_FALSE(keeps_apart(zone.walls, vehicle_at({10, 3.0}, 0.0, 8.0)));  // 10 cm from the kerb
  EXPECT_FALSE(keeps_apart(zone.walls, vehicle_at({10, 1.0}, 0.0, 8.0)));  // on it
  EXPECT_FALSE(keeps_apart(zone.walls, vehicle_at({10, 1.0}, 0.0, 0.0)));
  EXPECT_FALSE(keeps_apart(zone.walls, vehicle_at({10, 3.6}, -0.2, 8.0)));  // about to drive on it
}

TEST(Apart, goes_by_the_way_where_it_is_known) {
  const Zone zone = footways();
  VehicleState vehicle = vehicle_at({40, -10}, 0.0, 8.0);
  EXPECT_FALSE(keeps_apart(zone.walls, vehicle));
  const std::vector<Vec2> turns{{37.5, -10}, {45, -10}, {48, -13}, {48, -30}};
  vehicle.way = turns;
  EXPECT_TRUE(keeps_apart(zone.walls, vehicle));
  const std::vector<Vec2> crosses{{37.5, -10}, {45, -10}, {70, -10}};
  vehicle.way = crosses;
  EXPECT_FALSE(keeps_apart(zone.walls, vehicle));
}

TEST(Apart, is_nobody_in_open_space) {
  EXPECT_FALSE(keeps_apart(WallIndex(), vehicle_at({10, 3.6}, 0.0, 8.0)));
}

TEST(Apart, makes_no_difference_to_who_walks_beside_it) {
  const Zone zone = footways();
  const auto path_beside = [&](double y) {
    Scene scene(zone, 1);
    scene.add({2, 1.4}, point(50, 1.4));
    for (int k = 0; k < 4; ++k) {
      scene.vehicles.push_back(vehicle_at({60.0 + 20 * k, y}, kPi, 13.9));
      scene.vehicles.push_back(vehicle_at({-10.0 - 20 * k, y}, 0.0, 13.9));
    }
    scene.run(12.0);
    return scene.people[0].path;
  };
  EXPECT_EQ(path_beside(3.7), path_beside(60.0));
  EXPECT_NE(path_beside(3.0), path_beside(60.0));  // nearer to the kerb than that, they are minded
}

}  // namespace
}  // namespace pedzone::test
