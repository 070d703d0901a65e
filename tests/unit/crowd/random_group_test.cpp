// Random groups and families among obstacles and vehicles: whatever happens, all arrive who would
// arrive alone, somebody of each group goes on, hands are let go again, and nobody is outside.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "group_scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kSize = 40.0;       // [m] of the zone
constexpr double kHandReach = 10.0;  // [m] a vehicle this near is a reason for the hand
constexpr double kHandAhead = 5.1;   // [s] or so soon
constexpr double kHandTime = 2.5;    // [s] so long after it at most

/// One random scene, as data: it can be walked with its groups or without.
class RandomGroups {
 public:
  explicit RandomGroups(int seed) : random_(static_cast<std::uint64_t>(seed)) {
    for (std::size_t k = below(9); k > 0; --k) {
      const Vec2 corner{in(4, kSize - 4), in(0, kSize)};
      obstacles.push_back(
          box(corner.x(), corner.y(), corner.x() + in(0.3, 6), corner.y() + in(0.3, 8)));
    }
    zone = zone_of(box(0, 0, kSize, kSize), obstacles, true);
    for (std::uint64_t group = 1 + below(3); group > 0; --group) add_group(group);
    for (std::size_t k = below(3); k > 0; --k) add_vehicle();
  }

  std::vector<Ring> obstacles;
  Zone zone;
  std::vector<NewPerson> people;
  std::vector<VehicleState> vehicles;

 private:
  double in(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1.0p-53;
  }
  std::size_t below(std::size_t count) { return random_() % count; }

  void add_group(std::uint64_t group) {
    const bool eastward = below(2) == 0;
    const double y = in(4, kSize - 4), end = in(4, kSize - 4);
    const Destination to =
        eastward ? line_at_x(kSize - 0.5, end - 3, end + 3) : line_at_x(0.5, end - 3, end + 3);
    const bool family = below(2) == 0;
    const std::size_t size = 2 + below(5);
    for (std::size_t k = 0; k < size; ++k) {
      const double x = eastward ? in(0.5, 6) : in(kSize - 6, kSize - 0.5);
      NewPerson person = member({x, y + in(-3, 3)}, to, group);
      person.key = people.size() + 1;
      person.radius = in(0.18, 0.28);
      person.preferred_speed = in(0.8, 1.8);
      if (family && k > 0 && below(2) == 0) {
        person.profile = profile(below(2) == 0 ? "infant" : "child");
        person.radius = 0.15;
        person.preferred_speed = in(0.6, 1.3);
      }
      person.velocity = Vec2::Zero();
      person.place_freely = true;
      people.push_back(person);
    }
  }

  void add_vehicle() {
    const double heading = 0.5 * kPi * static_cast<double>(below(4)) + in(-0.2, 0.2);
    const Vec2 through{in(8, kSize - 8), in(8, kSize - 8)};
    vehicles.push_back(vehicle_at(through - in(25, 45) * unit(heading), heading, in(0.7, 3.5),
                                  in(3, 6), in(1.2, 2)));
  }

  std::mt19937_64 random_;
};

/// Within the square and in no obstacle, by a millimetre: shares nothing with the crowd's walls.
bool is_outside(const RandomGroups& scene, const Vec2& p) {
  constexpr double kSlack = 1e-3;
  const auto within = [&](const Ring& ring, double margin) {
    return p.x() > ring[0].x() - margin && p.x() < ring[2].x() + margin &&
           p.y() > ring[0].y() - margin && p.y() < ring[2].y() + margin;
  };
  if (!within(box(0, 0, kSize, kSize), kSlack)) return true;
  return std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                     [&](const Ring& ring) { return within(ring, -kSlack); });
}

/// Now or in the next seconds, along its straight way.
bool comes_near(VehicleState vehicle, const Vec2& point) {
  for (double t = 0.0; t <= kHandAhead; t += 0.1) {
    if (clearance(vehicle, point) < kHandReach) return true;
    vehicle.centre += 0.1 * vehicle.velocity;
  }
  return false;
}

class GroupsAtRandom : public ::testing::TestWithParam<int> {};

TEST_P(GroupsAtRandom, all_arrive_together) {
  const RandomGroups random(GetParam());
  Scene alone(random.zone), scene(random.zone);
  alone.vehicles = scene.vehicles = random.vehicles;
  for (NewPerson person : random.people) {
    scene.add(person);
    person.group = 0;
    alone.add(person);
  }
  alone.run(300);
  std::vector<double> vehicle_near(random.people.size(), -100.0);
  // Twice the time alone is what a group needs whose last member is stuck; more is a deadlock.
  const double limit = 2.0 * 300 + 100;
  while (scene.time < limit && scene.arrived() < scene.people.size()) {
    scene.step();
    std::map<std::uint64_t, bool> goes_on;
    for (std::size_t k = 0; k < scene.people.size(); ++k) {
      const Scene::Person& person = scene.people[k];
      if (!person.here) continue;
      ASSERT_FALSE(is_outside(random, person.view.position));
      goes_on[person.given.group] |= !person.view.waits_for_group;
      for (const VehicleState& vehicle : scene.vehicles) {
        if (comes_near(vehicle, person.view.position)) vehicle_near[k] = scene.time;
      }
      if (person.view.holds_hand) {
        ASSERT_LE(scene.time - vehicle_near[k], kHandTime);
        ASSERT_NE(person.given.profile, nullptr);
      }
    }
    for (const auto& [group, goes] : goes_on) ASSERT_TRUE(goes) << group;
  }
  for (std::size_t k = 0; k < scene.people.size(); ++k) {
    if (alone.people[k].here) continue;
    EXPECT_FALSE(scene.people[k].here) << k << " at " << scene.people[k].view.position.transpose()
                                       << ", alone after " << alone.people[k].arrival_time << " s";
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, GroupsAtRandom, ::testing::Range(1, 251));

}  // namespace
}  // namespace pedzone::test
