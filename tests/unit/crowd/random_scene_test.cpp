// Random zones, people, vehicles and events: whatever happens, everybody stays inside, finite and
// at a walking pace.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "scene.hpp"

namespace pedzone::test {
namespace {

/// [m] by which people push each other at most in a step, where somebody is put onto others and the
/// pile comes apart. Measured: 0.55.
constexpr double kPile = 0.7;
constexpr double kFastest = 6.0 + 0.3 * 6.0;  ///< [m/s] of a corner of a vehicle that turns

/// Whether a vehicle can have touched a body there in the last `dt` [s].
bool in_reach(const std::vector<VehicleState>& vehicles, const Vec2& at, double dt) {
  constexpr double kBody = 0.5;  // [m]
  return std::ranges::any_of(vehicles, [&](const VehicleState& vehicle) {
    const double size = 0.5 * std::hypot(vehicle.length, vehicle.width);
    return (vehicle.centre - at).norm() < size + kBody + kFastest * dt;
  });
}

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
    for (VehicleState& vehicle : vehicles) vehicle.centre += vehicle.velocity * dt;
    ASSERT_EQ(crowd.size(), known.size());
    for (Known& p : known) {
      const PersonView view = crowd.view(p.handle);
      ASSERT_TRUE(view.position.allFinite() && view.velocity.allFinite());
      ASSERT_TRUE(std::isfinite(view.heading));
      ASSERT_TRUE(its_zone.walls.inside(view.position));
      ASSERT_LE(view.velocity.norm(), 1.2 * p.speed + 1e-6);
      const double pushed = (view.position - p.position).norm() - p.speed * dt;
      ASSERT_LE(pushed, kPile + (in_reach(vehicles, view.position, dt) ? kFastest * dt : 0.0));
      p.position = view.position;
    }
    for (VehicleState& vehicle : vehicles) {
      if ((vehicle.centre - place()).norm() > 2 * kSize) vehicle.centre = place();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScene, ::testing::Range(1, 41));

}  // namespace
}  // namespace pedzone::test
