// Every walking model walks groups and people with waypoints, round obstacles and among others.
#include <gtest/gtest.h>

#include <algorithm>

#include "group_scene.hpp"
#include "world/model_names.hpp"

namespace pedzone::test {
namespace {

class CrowdModels : public ::testing::TestWithParam<std::string_view> {};

TEST_P(CrowdModels, groups_and_people_with_waypoints_arrive_inside_the_walls) {
  Zone zone = zone_of(box(0, 0, 40, 20), {box(18, 6, 22, 14)}, true);
  zone.model = std::string(GetParam());
  Scene scene(zone);
  const Destination east = line_at_x(39, 1, 19), west = line_at_x(1, 1, 19);
  for (const double y : {8.0, 10.0, 12.0}) scene.add(member({8.0, y}, east, 1));
  scene.add(member({1.5, 10.0}, east, 1));  // far behind: the others wait for it
  for (const double y : {9.0, 11.0}) scene.add(member({36.0, y}, west, 2));
  NewPerson detour = member({4.0, 3.0}, east, 0);
  detour.path = {{{20.0, 17.0}, 1.0}, {{20.0, 3.0}, 1.0}};
  const std::size_t last = scene.add(detour);
  scene.vehicles = {vehicle_at({30.0, 9.0}, 0.4, 0.0)};
  bool waited = false;
  while (scene.time < 200.0 && scene.arrived() < scene.people.size()) {
    scene.step();
    for (std::size_t k = 0; k < 3; ++k) waited = waited || scene.people[k].view.waits_for_group;
  }
  EXPECT_EQ(scene.arrived(), scene.people.size());
  EXPECT_GE(scene.least_wall_gap(), -0.24) << "a body's centre left the walkable area";
  EXPECT_GE(scene.least_vehicle_gap(), -0.01);
  EXPECT_TRUE(waited);
  for (const Waypoint& waypoint : detour.path) {
    const auto& path = scene.people[last].path;
    EXPECT_TRUE(std::ranges::any_of(
        path, [&](const Vec2& p) { return (p - waypoint.at).norm() <= waypoint.radius + 0.14; }));
  }
}

INSTANTIATE_TEST_SUITE_P(All, CrowdModels, ::testing::ValuesIn(kModelNames), [](const auto& model) {
  std::string name(model.param);
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace pedzone::test
