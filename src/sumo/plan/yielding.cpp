#include "sumo/plan/yielding.hpp"

#include <algorithm>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kStandsAfter = 5.0;  // [s] assumed: a driver looks after whom it has run into
constexpr double kOnce = 1.0;         // [s] numerical: braking again so soon is the same braking

}  // namespace

/// Nothing where the vehicle has run into nobody, or has stood for long enough since.
std::optional<YieldOrder> Yielding::plan_stop(FleetVehicle& vehicle, double dt) {
  const auto found = stopping_.find(vehicle.id);
  if (found == stopping_.end()) return std::nullopt;
  double& stood = found->second;
  if (vehicle.speed <= kHaltingSpeed) stood += dt;
  if (stood > kStandsAfter) {
    stopping_.erase(found);
    vehicle.commanded = kOwnSpeed;  // nobody in its way holds it
    return std::nullopt;
  }
  const double next = std::max(0.0, vehicle.speed - vehicle.traits.emergency_decel * dt);
  return YieldOrder{next, true};
}

void Yielding::command(FleetVehicle& vehicle, const YieldOrder& order,
                       std::vector<SpeedOrder>& out) {
  if (order.emergency && in_emergency_.insert(vehicle.id).second) {
    out.push_back({vehicle.id, SpeedMode::kEmergency});
  } else if (!order.emergency && in_emergency_.erase(vehicle.id) > 0) {
    out.push_back({vehicle.id, SpeedMode::kDefault});
  }
  out.push_back({vehicle.id, order.speed});
  vehicle.commanded = order.speed;
  commanded_.insert(vehicle.id);
}

void Yielding::give_back(FleetVehicle& vehicle, std::vector<SpeedOrder>& out) {
  vehicle.commanded = kOwnSpeed;
  if (commanded_.erase(vehicle.id) == 0) return;
  out.push_back({vehicle.id, kOwnSpeed});
  if (in_emergency_.erase(vehicle.id) > 0) out.push_back({vehicle.id, SpeedMode::kDefault});
}

void Yielding::note(const FleetVehicle& vehicle, double time) {
  const auto [last, is_new] = braked_late_.try_emplace(vehicle.id, time);
  if (is_new || time > last->second + kOnce) {
    late_brakings_.push_back({time, vehicle.id, vehicle.front, -vehicle.pull});
  }
  last->second = time;
}

std::vector<SpeedOrder> Yielding::plan(std::span<FleetVehicle> vehicles,
                                       std::span<const PersonAhead> people,
                                       const SafeSpeeds& safe_speeds, double time, double dt) {
  std::vector<SpeedOrder> orders;
  for (FleetVehicle& vehicle : vehicles) {
    if (const auto stop = plan_stop(vehicle, dt); stop && !vehicle.traits.external) {
      command(vehicle, *stop, orders);
      continue;
    }
    if (!vehicle.traits.yields || vehicle.traits.external || vehicle.stopped) {
      if (!vehicle.traits.external) give_back(vehicle, orders);
      continue;
    }
    const auto order =
        plan_yield(vehicle, people, zones_[vehicle.zone].parameters, safe_speeds, dt);
    if (order && order->emergency) note(vehicle, time);
    if (order) {
      command(vehicle, *order, orders);
      yielded_.insert(vehicle.id);
    } else {
      give_back(vehicle, orders);
    }
  }
  return orders;
}

}  // namespace pedzone
