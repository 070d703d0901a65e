// Helbing and Molnár (1995, Fig. 3): two crowds want through a narrow door. Whoever passes is
// followed by others of its side, until the pressure of the other side turns the flow.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kWall = 10.0;  // [m] where the door is

/// 20 m by 8 m with a wall across its middle and a door of `width` [m] in it.
Zone rooms(double width) {
  const double low = 4.0 - width / 2.0, high = 4.0 + width / 2.0;
  Zone zone = zone_of(
      box(0, 0, 20, 8),
      {box(kWall - 0.1, -1, kWall + 0.1, low), box(kWall - 0.1, high, kWall + 0.1, 9)}, true);
  zone.model = "social-force";
  // As in the paper, where those behind push, too: without them nobody backs out of the door.
  zone.parameters.field_of_view = 180.0;
  return zone;
}

/// Who has passed the door for good, in that order: 1 to the right, -1 to the left.
std::vector<int> passages(const Zone& zone, std::uint64_t seed, int each_side, double until) {
  Scene scene(zone, seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> x(1.0, 8.5), y(1.0, 7.0);
  for (int k = 0; k < 2 * each_side; ++k) {
    NewPerson person;
    const double side = k % 2 == 0 ? 1.0 : -1.0;
    person.position = Vec2(kWall + side * (x(random) - kWall), y(random));
    person.destination = line_at_x(kWall + side * 9.5, 0, 8);
    person.place_freely = true;
    scene.add(person);
  }
  std::vector<std::pair<double, int>> passed(scene.people.size());  // time of the last passage
  while (scene.time < until && scene.arrived() < scene.people.size()) {
    scene.step();
    for (std::size_t k = 0; k < passed.size(); ++k) {
      const std::vector<Vec2>& path = scene.people[k].path;
      const bool right = path.back().x() >= kWall;
      const bool crosses = right != (path[path.size() - 2].x() >= kWall);
      if (scene.people[k].here && crosses) passed[k] = {scene.time, right ? 1 : -1};
    }
  }
  EXPECT_EQ(scene.arrived(), scene.people.size()) << "seed " << seed;
  EXPECT_GE(scene.least_wall_gap(), -1e-6);
  std::ranges::sort(passed);
  std::vector<int> order;
  for (const auto& [time, way] : passed) order.push_back(way);
  return order;
}

TEST(Door, is_passed_in_turns_by_people_of_the_social_force_model) {
  Zone zone = rooms(1.2);
  zone.parameters.turned_width = 1.0;  // as in the paper: who turns passes others in the door
  int passed = 0, runs = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<int> order = passages(zone, seed, 20, 300.0);
    passed += static_cast<int>(order.size());
    runs += 1;
    for (std::size_t k = 1; k < order.size(); ++k) runs += order[k] != order[k - 1] ? 1 : 0;
  }
  RecordProperty("mean_run", std::to_string(static_cast<double>(passed) / runs));
  // In an order by chance, about two pass between two turns.
  EXPECT_GT(static_cast<double>(passed) / runs, 3.0);
}

}  // namespace
}  // namespace pedzone::test
