#include "crowd/behaviour/dash.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "crowd/sense/danger.hpp"
#include "crowd/sense/vehicle_motion.hpp"
#include "crowd/state/parallel.hpp"

namespace pedzone {
namespace {

constexpr double kMinute = 60.0;
constexpr double kReach = 15.0;  // [m] assumed: from farther away nobody runs at a vehicle
constexpr double kTime = 3.0;    // [s] assumed: and so long it runs

/// The moving vehicle nearest to the person within kReach; null: none.
const VehicleState* nearest_moving(const CrowdState& crowd, std::size_t i) {
  const VehicleState* nearest = nullptr;
  double least = kReach;
  for (const std::uint32_t v : crowd.vehicles_near.at(crowd.position(i), kReach)) {
    const VehicleState& vehicle = crowd.vehicles[v];
    const double distance = (vehicle.centre - crowd.position(i)).norm();
    if (distance >= least || !drives(vehicle)) continue;
    least = distance;
    nearest = &vehicle;
  }
  return nearest;
}

bool begins(const CrowdState& crowd, std::size_t i, double dt) {
  const WalkState& walker = crowd.walkers[i];
  if (walker.profile == nullptr || walker.profile->impulsiveness <= 0.0) return false;
  if (walker.arrived || nearest_moving(crowd, i) == nullptr) return false;
  const double stays = std::exp(-walker.profile->impulsiveness * dt / kMinute);
  return random_uniform(crowd.seed, crowd.persons.key[i], crowd.clock.substep, Purpose::kImpulse) >=
         stays;
}

}  // namespace

void begin_dashes(const CrowdState& crowd, double dt, ByHandle<ActivityMemory>& activities) {
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      double& left = activities[crowd.handle(i)].dash;
      left = std::max(0.0, left - dt);
      if (left <= 0.0 && begins(crowd, i, dt)) left = kTime;
    }
  });
}

void propose_dashes(const CrowdState& crowd, Proposals& proposals, Attention& attention) {
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    if (crowd.activities[crowd.handle(i)].dash <= 0.0) continue;
    const VehicleState* vehicle = nearest_moving(crowd, i);
    if (vehicle == nullptr) continue;
    const Vec2 here = crowd.position(i);
    const Vec2 front = front_of(*vehicle);
    const double time = (front - here).norm() / crowd.persons.preferred_speed[i];
    proposals.propose(i, towards(front + vehicle->velocity * time - here, Behaviour::kDash));
    attention.ignore(i, static_cast<std::size_t>(vehicle - crowd.vehicles.data()));
  }
}

}  // namespace pedzone
