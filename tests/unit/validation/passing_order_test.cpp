// Who passed first: what is found with parts of ways and a time window is what looking at every
// piece of every way finds, bit for bit.
#include "validation/passing_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace pedzone::test {
namespace {

/// The plain search of one vehicle: each frame of it with each piece of the way.
std::optional<PassingOrder> by_every_piece(const VehicleTrack& vehicle, int first,
                                           const Polyline& way) {
  std::optional<PassingOrder> closest;
  for (std::size_t j = 0; j + 1 < vehicle.states.size(); ++j) {
    if (vehicle.states[j].velocity.norm() < kMovingSpeed) continue;
    const Vec2 a = vehicle.states[j].centre, along = vehicle.states[j + 1].centre - a;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      const Vec2 to = a - way[i], step = way[i + 1] - way[i];
      const double near = along.norm() + 1.0, area = cross(step, along);
      if (to.squaredNorm() > near * near || area == 0.0) continue;
      const double walked = cross(to, along) / area, driven = cross(to, step) / area;
      if (walked < 0.0 || walked >= 1.0 || driven < 0.0 || driven >= 1.0) continue;
      const Vec2 place = a + driven * along;
      std::size_t enter = j, leave = j;
      while (enter > 0 && signed_clearance(vehicle.states[enter - 1], place) <= 0.0) --enter;
      while (leave + 1 < vehicle.states.size() &&
             signed_clearance(vehicle.states[leave + 1], place) <= 0.0) {
        ++leave;
      }
      const double when = first + static_cast<double>(i) + walked;
      const double before = vehicle.first + static_cast<double>(enter) - when;
      const double after = when - (vehicle.first + static_cast<double>(leave));
      const PassingOrder found{when < vehicle.first + static_cast<double>(j) + driven,
                               std::max({0.0, before, after}) * kFrame};
      if (!closest || found.gap < closest->gap) closest = found;
    }
  }
  return closest;
}

std::optional<PassingOrder> by_every_piece(const Clip& clip, int first, const Polyline& way) {
  std::optional<PassingOrder> closest;
  for (const VehicleTrack& vehicle : clip.vehicles) {
    const auto found = by_every_piece(vehicle, first, way);
    if (found && (!closest || found->gap < closest->gap)) closest = found;
  }
  return closest;
}

/// Ways with bends and rests, of steps that keep their direction for a while: from anywhere to
/// anywhere, or north over a street of vehicles that drive east.
Polyline random_way(std::mt19937& random, std::size_t frames, double speed, bool street) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Polyline way{{60.0 * share(random) - 30.0, 60.0 * share(random) - 30.0}};
  double heading = 6.28 * share(random), now = speed;
  if (street) {
    const bool walks = speed < 2.0;
    way[0] = walks ? Vec2(20.0 * share(random), -10.0) : Vec2(-20.0, share(random));
    heading = walks ? 1.5 : 0.0;
  }
  while (way.size() < frames) {
    if (share(random) < 0.03) heading += 2.0 * share(random) - 1.0;
    if (share(random) < 0.03) now = share(random) < 0.3 ? 0.0 : speed;
    way.push_back(way.back() + 0.1 * now * unit(heading));
  }
  return way;
}

VehicleTrack random_vehicle(std::mt19937& random, int until, bool street) {
  std::uniform_int_distribution<int> begin(0, until), frames(1, 150);
  VehicleTrack track{"v", begin(random), {}};
  const Polyline way = random_way(random, static_cast<std::size_t>(frames(random)), 5.0, street);
  for (std::size_t k = 0; k < way.size(); ++k) {
    VehicleState state;
    state.centre = way[k];
    const Vec2 by = k > 0 ? Vec2(way[k] - way[k - 1]) : Vec2(0.5, 0.0);
    state.velocity = 10.0 * by;
    state.heading =
        by.norm() > 0.0 || k == 0 ? std::atan2(by.y(), by.x()) : track.states.back().heading;
    state.length = 4.4;
    state.width = 1.8;
    track.states.push_back(state);
  }
  return track;
}

TEST(PassingOrder, is_that_of_every_piece_of_every_way) {
  int none = 0, at_once = 0, later = 0, person_first = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const int until = seed % 3 == 0 ? 100 : 2000;  // all at a time, or one after the other
    const bool street = seed % 2 == 0;
    Clip clip;
    for (int v = 0; v < 30; ++v) clip.vehicles.push_back(random_vehicle(random, until, street));
    const VehicleWays ways(clip);
    for (int p = 0; p < 30; ++p) {
      const int first = std::uniform_int_distribution<int>(0, until)(random);
      const auto frames = std::uniform_int_distribution<std::size_t>(1, 300)(random);
      const Polyline way = random_way(random, frames, 1.3, street);
      const auto found = ways.closest(first, way), expected = by_every_piece(clip, first, way);
      ASSERT_EQ(found.has_value(), expected.has_value()) << seed << ' ' << p;
      none += expected ? 0 : 1;
      if (!expected) continue;
      ASSERT_EQ(found->gap, expected->gap) << seed << ' ' << p;
      ASSERT_EQ(found->person_first, expected->person_first) << seed << ' ' << p;
      ++(expected->gap > 0.0 ? later : at_once);
      person_first += expected->person_first ? 1 : 0;
    }
  }
  // All kinds were there.
  EXPECT_GT(none, 100);
  EXPECT_GT(at_once, 10);
  EXPECT_GT(later, 300);
  EXPECT_GT(person_first, 100);
}

/// A vehicle of 4 m that drives east over (0, 0), its centre there at `frame`.
VehicleTrack eastward(int frame) {
  VehicleTrack track{"v", frame - 40, {}};
  for (int k = 0; k <= 80; ++k) {
    VehicleState state;
    state.centre = {0.5 * (k - 40), 0.0};
    state.velocity = {5.0, 0.0};
    state.length = 4.0;
    state.width = 2.0;
    track.states.push_back(state);
  }
  return track;
}

TEST(PassingOrder, is_with_the_first_of_vehicles_that_are_equally_close) {
  Polyline way;  // at (0.1, 0) in frame 100.5
  for (int k = 0; k <= 60; ++k) way.emplace_back(0.1, 0.13 * k - 3.965);
  Clip clip;
  // Both are over the place when the person is, the one before, the other after its centre.
  clip.vehicles = {eastward(99), eastward(102)};
  const auto one = VehicleWays(clip).closest(70, way);
  std::swap(clip.vehicles[0], clip.vehicles[1]);
  const auto other = VehicleWays(clip).closest(70, way);
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->gap, 0.0);
  EXPECT_EQ(other->gap, 0.0);
  EXPECT_FALSE(one->person_first);
  EXPECT_TRUE(other->person_first);
}

}  // namespace
}  // namespace pedzone::test
