#include "crowd/behaviour/rears.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "crowd/sense/vehicle_motion.hpp"
#include "crowd/state/parallel.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kRoom = 0.1;       // [m] assumed: left between a body and the rear that passes it
constexpr double kReach = 2.0;      // [m] numerical: nobody gets farther while a rear swings by
constexpr double kForesight = 1.5;  // [s] assumed: so far ahead people see it swing
constexpr double kStays = 3.0;      // [s] numerical: as long as anybody waits for a rear
constexpr double kLook = 0.2;       // [s] numerical: sampling of that
constexpr double kTurns = 0.01;     // [rad] numerical: less is no bend
constexpr double kRounding = 1e-6;  // [s] numerical

/// Whether the rear of a vehicle swings nearer than `reach` [m] to who walks on from `here` with
/// `velocity` [m/s], and not so near to who stays.
bool swings_at(const VehicleState& vehicle, const Rectangle& body, const Vec2& here,
               const Vec2& velocity, double reach) {
  const double speed = vehicle.velocity.norm();
  if (!vehicle.forwards || speed < kHaltingSpeed) return false;
  const bool before = body.into_frame(here).x() > body.half.x();  // models mind its front
  if (before || body.distance(here) > kReach) return false;
  for (double ahead = kLook; ahead < kForesight + kRounding; ahead += kLook) {
    const Rectangle later = body_shifted(vehicle, speed * ahead);
    if (std::abs(cross(body.axis, later.axis)) < kTurns) continue;
    const Vec2 there = here + velocity * ahead;
    const double room = later.distance(there);
    const bool comes_nearer = room <= body.distance(there);
    if (room < reach && comes_nearer && room < later.distance(here)) return true;
  }
  return false;
}

/// Whether the vehicle is about to get nearer than `reach` [m], and than it is, to who stays.
bool comes_over(const VehicleState& vehicle, const Vec2& here, double reach) {
  if (vehicle.velocity.norm() < kHaltingSpeed) return false;
  const double now = distance_to(vehicle, here);
  for (double ahead = kLook; ahead < kStays + kRounding; ahead += kLook) {
    const double room = distance_to(moved_on(vehicle, ahead), here);
    if (room < reach && room < now) return true;
  }
  return false;
}

/// Not for one that turns round, nor on another's lane: it would be reached where it waits.
bool waits_for_rear(const CrowdState& crowd, std::size_t i) {
  const Decision& decided = crowd.decisions[i];
  if (decided.speed < kStaticSpeed) return false;
  const Vec2 here = crowd.position(i), velocity = unit(decided.direction) * decided.speed;
  const double radius = crowd.persons.radius[i], reach = radius + kRoom;
  const auto swings = [&](std::uint32_t v) {
    return swings_at(crowd.vehicles[v], crowd.vehicle_bodies[v], here, velocity, reach);
  };
  if (std::ranges::none_of(crowd.vehicles_near.at(here, kReach), swings)) return false;
  const auto coming = crowd.vehicles_near.at(here, reach, kStays);
  return std::ranges::none_of(coming, [&](std::uint32_t v) {
    // Past the one that it waits for it need not be clear by more than its body.
    return comes_over(crowd.vehicles[v], here, swings(v) ? radius : reach);
  });
}

}  // namespace

void restrain_beside_rears(const CrowdState& crowd, Restraints& restraints) {
  if (crowd.vehicles.empty()) return;
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (!crowd.walkers[i].arrived && !crowd.is_over(i) && waits_for_rear(crowd, i))
        restraints.wait(i);
    }
  });
}

}  // namespace pedzone
