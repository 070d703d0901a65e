#include "sumo/plan/outside_drivers.hpp"

#include <algorithm>
#include <cmath>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kSame = 0.05;   // [m/s] numerical
constexpr double kBrakes = 0.9;  // numerical: of its decel
constexpr int kSure = 2;         // numerical: steps; a stop or an insertion is odd for one
constexpr double kLetGo = 2.0;   // [s] assumed: a controller is not equal to SUMO for so long

/// Whether it is at least about as much slower than before as it likes to brake.
bool brakes(const VehicleSeen& vehicle, double before, double dt) {
  return vehicle.speed <= std::max(0.0, before - kBrakes * vehicle.traits.decel * dt);
}

}  // namespace

/// One that pedzone has told a speed drives no faster, but for what it cannot brake. Once another
/// program drives it, what it was told may count no more: then it may drive as SUMO lets it, too.
bool OutsideDrivers::is_odd(const VehicleSeen& vehicle, const Suspect& suspect, double dt) const {
  const std::optional<double> told = told_.speed(vehicle.id);
  // Beside emergency vehicles SUMO tells a lower speed of its own for one that brakes.
  const bool is_faster = vehicle.speed > vehicle.own_speed;
  const bool as_sumo = std::abs(vehicle.speed - vehicle.own_speed) <= kSame;
  if (!told) return !as_sumo && !(is_faster && brakes(vehicle, suspect.last_speed, dt));
  if (suspect.driven && as_sumo) return false;
  if (suspect.last_speed < 0.0) return false;
  const double slowest = suspect.last_speed - vehicle.traits.decel * dt;
  return vehicle.speed > std::max(*told, slowest) + kSame;
}

void OutsideDrivers::mark(std::vector<VehicleSeen>& seen,
                          const std::unordered_set<std::string>& steered, double time, double dt) {
  for (VehicleSeen& vehicle : seen) {
    any_ = any_ || vehicle.traits.external;
    if (vehicle.traits.external || steered.contains(vehicle.id)) continue;
    Suspect& suspect = suspects_[vehicle.id];
    const bool odd = !vehicle.stopped && is_odd(vehicle, suspect, dt);
    suspect.last_speed = vehicle.speed;
    suspect.odd_steps = odd ? suspect.odd_steps + 1 : 0;
    if (odd) suspect.as_sumo = 0.0;
    if (!odd && vehicle.speed > kHaltingSpeed) suspect.as_sumo += dt;
    if (suspect.odd_steps >= kSure) suspect.driven = true;
    if (suspect.as_sumo >= kLetGo) suspect.driven = false;
    vehicle.traits.external = suspect.driven;
    any_ = any_ || suspect.driven;
    if (!suspect.driven || suspect.told_of) continue;
    suspect.told_of = true;
    found_.push_back({time, vehicle.id});
  }
}

}  // namespace pedzone
