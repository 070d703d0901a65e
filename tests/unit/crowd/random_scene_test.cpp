// Random zones, people, vehicles and events: whatever happens, everybody stays inside, finite and
// at a walking pace.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scene.hpp"

namespace pedzone::test {
namespace {

class RandomScene : public ::testing::TestWithParam<int> {
 protected:
  double in(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1.0p-53;
  }
  std::size_t below(std::size_t count) { return random_() % count; }
  Vec2 place(double margin = 0.0) {
    return {in(-margin, kSize + margin), in(-margin, kSize + margin)};
  }

  Zone zone() {
    std::vector<Ring> obstacles;
    for (std::size_t k = below(12); k > 0; --k) {
      const Vec2 corner = place();
      obstacles.push_back(
          box(corner.x(), corner.y(), corner.x() + in(0.1, 9), corner.y() + in(0.1, 9)));
    }
    return zone_of(box(0, 0, kSize, kSize), obstacles, below(2) == 0);
  }

  Destination destination() {
    const Vec2 a = place(2.0);
    return below(2) == 0 ? Destination{a, a} : Destination{a, a + in(0.1, 10) * unit(in(-3, 3))};
  }

  NewPerson person(std::uint64_t key) {
    NewPerson p;
    p.key = key;
    p.position = place(1.0);
    p.heading = in(-kPi, kPi);
    p.velocity = in(0, 2) * unit(p.heading);
    p.radius = in(0.1, 0.5);
    p.preferred_speed = in(0.3, 2.5);
    p.destination = destination();
    p.place_freely = below(2) == 0;
    return p;
  }

  static constexpr double kSize = 40.0;
  std::mt19937_64 random_{static_cast<std::uint64_t>(GetParam())};
};

TEST_P(RandomScene, keeps_its_invariants) {
  const Zone its_zone = zone();
  Crowd crowd(its_zone, random_());
  struct Known {
    Crowd::Handle handle;
    double speed;
    Vec2 position;
  };
  std::vector<Known> known;
  std::vector<VehicleState> vehicles;
  for (std::size_t k = below(4); k > 0; --k) {
    vehicles.push_back(vehicle_at(place(), in(-kPi, kPi), in(-2, 6), in(1, 12), in(0.6, 2.6)));
    vehicles.back().yaw_rate = in(-0.3, 0.3);
  }
  const double fastest_vehicle = 6.0 + 0.3 * 6.0;
  std::uint64_t key = 1;
  for (int step = 0; step < 120; ++step) {
    while (known.size() < 60 && below(3) != 0) {
      const NewPerson p = person(key++);
      const Crowd::Handle handle = crowd.add(p);
      known.push_back({handle, p.preferred_speed, crowd.view(handle).position});
    }
    if (!known.empty() && below(3) == 0) {
      const std::size_t k = below(known.size());
      crowd.remove(known[k].handle);
      known.erase(known.begin() + static_cast<std::ptrdiff_t>(k));
    }
    if (!known.empty() && below(4) == 0) {
      crowd.set_destination(known[below(known.size())].handle, destination());
    }
    if (below(5) == 0)
      crowd.see(std::vector<SeenPerson>{{place(), in(0, 2) * unit(in(-3, 3)), 0.3}});
    const double dt = below(2) == 0 ? 0.1 : in(0.01, 1.0);
    crowd.step(dt, vehicles);
    for (VehicleState& vehicle : vehicles) {
      vehicle.centre += vehicle.velocity * dt;
      if ((vehicle.centre - place()).norm() > 2 * kSize) vehicle.centre = place();
    }
    ASSERT_EQ(crowd.size(), known.size());
    for (Known& p : known) {
      const PersonView view = crowd.view(p.handle);
      ASSERT_TRUE(view.position.allFinite() && view.velocity.allFinite());
      ASSERT_TRUE(std::isfinite(view.heading));
      ASSERT_TRUE(its_zone.walls.inside(view.position));
      ASSERT_LE(view.velocity.norm(), p.speed + 1e-9);
      // Walking, being pushed by people (0.05 m and its own way, four passes a substep) and by
      // vehicles (their own way and 0.2 m a substep, each).
      const double substeps = std::ceil(dt / 0.1);
      const double pushes =
          substeps * 4 * (0.05 + p.speed * 0.1) +
          (fastest_vehicle * dt + substeps * 0.2) * static_cast<double>(vehicles.size());
      ASSERT_LE((view.position - p.position).norm(), p.speed * dt + pushes + 1e-9);
      p.position = view.position;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScene, ::testing::Range(1, 41));

}  // namespace
}  // namespace pedzone::test
