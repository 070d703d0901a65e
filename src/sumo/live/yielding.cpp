#include "sumo/live/yielding.hpp"

#include "sumo/live/api.hpp"

namespace pedzone {
namespace {

constexpr double kPersonDecel = 5.0;     // [m/s²] assumed: a walker stops within half a metre
constexpr int kSpeedModeDefault = 31;    // SUMO: all checks
constexpr int kSpeedModeEmergency = 27;  // the same without the bound of comfortable braking

const SafeSpeeds kSumoSpeeds{[](const FleetVehicle& vehicle, double gap) {
                               return api::Vehicle::getStopSpeed(vehicle.id, vehicle.speed, gap);
                             },
                             [](const FleetVehicle& vehicle, double gap, double speed) {
                               return api::Vehicle::getFollowSpeed(vehicle.id, vehicle.speed, gap,
                                                                   speed, kPersonDecel);
                             }};

}  // namespace

void Yielding::command(FleetVehicle& vehicle, const YieldOrder& order) {
  if (order.emergency && in_emergency_.insert(vehicle.id).second) {
    api::Vehicle::setSpeedMode(vehicle.id, kSpeedModeEmergency);
  } else if (!order.emergency && in_emergency_.erase(vehicle.id) > 0) {
    api::Vehicle::setSpeedMode(vehicle.id, kSpeedModeDefault);
  }
  api::Vehicle::setSpeed(vehicle.id, order.speed);
  vehicle.commanded = order.speed;
  held_.insert(vehicle.id);
  yielded_.insert(vehicle.id);
}

void Yielding::give_back(FleetVehicle& vehicle) {
  vehicle.commanded = -1.0;
  if (held_.erase(vehicle.id) == 0) return;
  api::Vehicle::setSpeed(vehicle.id, -1.0);
  if (in_emergency_.erase(vehicle.id) > 0) {
    api::Vehicle::setSpeedMode(vehicle.id, kSpeedModeDefault);
  }
}

void Yielding::apply(Fleet& fleet, std::span<const PersonAhead> people, double dt) {
  for (FleetVehicle& vehicle : fleet.vehicles()) {
    if (!vehicle.traits.yields || vehicle.traits.external || vehicle.stopped) {
      if (!vehicle.traits.external) give_back(vehicle);
      continue;
    }
    const auto order =
        plan_yield(vehicle, people, zones_[vehicle.zone].parameters, kSumoSpeeds, dt);
    if (order) {
      command(vehicle, *order);
    } else {
      give_back(vehicle);
    }
  }
}

}  // namespace pedzone
