// Vehicles behind a kerb: who keeps off people's ground is not given way to.
#include "crowd/sense/apart.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "scene.hpp"

namespace pedzone::test {
namespace {

/// A footway of 2 m beside a lane of 3.2 m, and one along the crossroad at x = 60.
Zone footways() { return zone_of(Ring{{0, 0}, {58, 0}, {58, -20}, {60, -20}, {60, 2}, {0, 2}}); }

bool apart(const WallIndex& walls, const VehicleState& vehicle) {
  return ground_ahead(walls, vehicle).isEmpty();
}

TEST(Apart, is_who_drives_beside_people) {
  const Zone zone = footways();
  EXPECT_TRUE(apart(zone.walls, vehicle_at({10, 3.6}, 0.0, 8.0)));
  EXPECT_TRUE(apart(zone.walls, vehicle_at({10, 3.6}, kPi, 8.0)));
  EXPECT_FALSE(apart(zone.walls, vehicle_at({10, 3.0}, 0.0, 8.0)));  // 10 cm from the kerb
  EXPECT_FALSE(apart(zone.walls, vehicle_at({10, 1.0}, 0.0, 8.0)));  // on it
  EXPECT_FALSE(apart(zone.walls, vehicle_at({10, 1.0}, 0.0, 0.0)));
  EXPECT_FALSE(apart(zone.walls, vehicle_at({10, 3.6}, -0.2, 8.0)));  // about to drive on it
}

TEST(Apart, goes_by_the_way_where_it_is_known) {
  const Zone zone = footways();
  VehicleState vehicle = vehicle_at({40, -10}, 0.0, 8.0);
  EXPECT_FALSE(apart(zone.walls, vehicle));
  const std::vector<Vec2> turns{{37.5, -10}, {45, -10}, {48, -13}, {48, -30}};
  vehicle.way = turns;
  EXPECT_TRUE(apart(zone.walls, vehicle));
  const std::vector<Vec2> crosses{{37.5, -10}, {45, -10}, {70, -10}};
  vehicle.way = crosses;
  EXPECT_FALSE(apart(zone.walls, vehicle));
}

TEST(Apart, is_nobody_in_open_space) {
  EXPECT_FALSE(apart(WallIndex(), vehicle_at({10, 3.6}, 0.0, 8.0)));
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

/// A footway beside a lane, and a crossing at x = 60 that leads over the lane to a square.
Zone zebra() {
  return zone_of(Ring{{0, 0},
                      {80, 0},
                      {80, 2},
                      {64, 2},
                      {64, 8},
                      {90, 8},
                      {90, 60},
                      {30, 60},
                      {30, 8},
                      {60, 8},
                      {60, 2},
                      {0, 2}});
}

TEST(Ground, is_where_the_way_leads_over_it) {
  const Zone zone = zebra();
  VehicleState vehicle = vehicle_at({20, 5}, 0.0, 10.0);
  const std::vector<Vec2> straight{{17.5, 5}, {75, 5}};
  vehicle.way = straight;
  const Eigen::AlignedBox2d ground = ground_ahead(zone.walls, vehicle);
  EXPECT_NEAR(ground.min().x(), 58.0, 3.0);
  EXPECT_NEAR(ground.max().x(), 66.0, 3.0);
  vehicle.ground = ground;
  EXPECT_FALSE(vehicle.concerns({30, 1}));
  EXPECT_TRUE(vehicle.concerns({50, 1}));
  const std::vector<Vec2> onto_the_square{{17.5, 5}, {62, 5}, {62, 40}, {70, 40}};
  vehicle.way = onto_the_square;
  EXPECT_NEAR(ground_ahead(zone.walls, vehicle).max().y(), 40.0, 1.0) << "far from all walls, too";
}

TEST(Ground, is_everywhere_for_who_is_on_it) {
  const Zone zone = zebra();
  VehicleState vehicle = vehicle_at({60, 5}, 0.0, 10.0);
  vehicle.ground = ground_ahead(zone.walls, vehicle);
  EXPECT_TRUE(vehicle.concerns({0, 1}));
}

TEST(Ground, makes_no_difference_to_who_is_far_from_it) {
  const Zone zone = zebra();
  const auto path = [&](double x, bool cars) {
    Scene scene(zone, 1);
    scene.add({x, 1.4}, point(x + 6, 1.4));
    if (cars) scene.vehicles.push_back(vehicle_at({x + 12, 4.2}, kPi, 8.0));
    if (cars) scene.vehicles.push_back(vehicle_at({x - 18, 4.2}, 0.0, 8.0));
    scene.run(3.0);
    return scene.people[0].path;
  };
  EXPECT_EQ(path(2, true), path(2, false));
  EXPECT_NE(path(53, true), path(53, false));
}

}  // namespace
}  // namespace pedzone::test
