#include "sumo/live/sumo_vehicle.hpp"

#include <algorithm>

#include "sumo/files/frames.hpp"
#include "sumo/live/api.hpp"
#include "sumo/plan/zone_route.hpp"

namespace pedzone {
namespace {

constexpr double kPersonDecel = 5.0;  // [m/s²] assumed: a walker stops within half a metre
constexpr int kExactPlace = 2;        // SUMO's keepRoute: anywhere, on a lane or not
constexpr double kLaneReach = 100.0;  // [m] SUMO's default: so near it looks for a lane

bool is_true(const std::string& text) { return text == "true" || text == "1" || text == "yes"; }
bool is_false(const std::string& text) { return text == "false" || text == "0" || text == "no"; }

/// A vehicle's parameter, else its type's.
std::string parameter(const std::string& id, const std::string& key) {
  const std::string own = api::Vehicle::getParameter(id, key);
  return own.empty() ? api::VehicleType::getParameter(api::Vehicle::getTypeID(id), key) : own;
}

/// On a slippery road neither SUMO nor we may brake as on a dry one.
void reduce_braking(const std::string& id, double grip, VehicleTraits& traits) {
  traits.decel *= grip;
  traits.emergency_decel *= grip;
  api::Vehicle::setEmergencyDecel(id, traits.emergency_decel);
  api::Vehicle::setDecel(id, traits.decel);
}

}  // namespace

const VehicleTraits& VehicleReader::traits(const std::string& id, double grip) {
  const auto [entry, is_new] = traits_.try_emplace(id);
  VehicleTraits& traits = entry->second;
  if (is_new) {
    traits.length = api::Vehicle::getLength(id);
    traits.width = api::Vehicle::getWidth(id);
    traits.decel = api::Vehicle::getDecel(id);
    traits.emergency_decel = std::max(traits.decel, api::Vehicle::getEmergencyDecel(id));
    traits.accel = api::Vehicle::getAccel(id);
    if (grip < 1.0) reduce_braking(id, grip, traits);
    traits.yields = !is_false(parameter(id, "pedzone.yield"));
    traits.external = is_true(parameter(id, "pedzone.external"));
    traits.electric = is_true(parameter(id, "pedzone.electric"));
  }
  return traits;
}

const std::vector<int>& VehicleReader::route(const std::string& id) {
  const auto [entry, is_new] = routes_.try_emplace(api::Vehicle::getRouteID(id));
  if (is_new) entry->second = edge_indices(network_, api::Vehicle::getRoute(id));
  return entry->second;
}

std::vector<VehicleSeen> VehicleReader::read(const Fleet& fleet) {
  std::vector<VehicleSeen> seen;
  for (const std::string& id : api::Vehicle::getIDList()) {
    const auto front = sumo_vehicle::front(id);
    if (!front || !fleet.near_zone(*front)) continue;
    VehicleSeen vehicle;
    vehicle.id = id;
    vehicle.traits = traits(id, fleet.grip());
    vehicle.front = *front;
    vehicle.heading = radians_from_sumo(api::Vehicle::getAngle(id));
    vehicle.speed = std::max(0.0, api::Vehicle::getSpeed(id));
    vehicle.allowed_speed = api::Vehicle::getAllowedSpeed(id);
    vehicle.time_loss = api::Vehicle::getTimeLoss(id);
    vehicle.horn = is_true(parameter(id, "pedzone.horn"));
    vehicle.invites = parameter(id, "pedzone.signal") == "after-you";
    vehicle.stopped = sumo_vehicle::is_at_stop(id);
    const auto lane = network_.lane_index.find(api::Vehicle::getLaneID(id));
    if (lane != network_.lane_index.end()) {
      vehicle.lane = lane->second;
      vehicle.lateral = api::Vehicle::getLateralLanePosition(id);
      vehicle.route = route(id);
      vehicle.route_index = api::Vehicle::getRouteIndex(id);
    }
    seen.push_back(std::move(vehicle));
  }
  return seen;
}

namespace sumo_vehicle {

std::vector<std::string> ids() { return api::Vehicle::getIDList(); }

double length(const std::string& id) { return api::Vehicle::getLength(id); }

std::optional<Vec2> front(const std::string& id) {
  const auto position = api::Vehicle::getPosition(id);
  if (position.x == libsumo::INVALID_DOUBLE_VALUE) return std::nullopt;
  return Vec2(position.x, position.y);
}

std::string edge(const std::string& id) { return api::Vehicle::getRoadID(id); }

bool is_at_stop(const std::string& id) { return (api::Vehicle::getStopState(id) & 1) != 0; }

SafeSpeeds safe_speeds() {
  return {[](const FleetVehicle& vehicle, double gap) {
            return api::Vehicle::getStopSpeed(vehicle.id, vehicle.speed, gap);
          },
          [](const FleetVehicle& vehicle, double gap, double speed) {
            return api::Vehicle::getFollowSpeed(vehicle.id, vehicle.speed, gap, speed,
                                                kPersonDecel);
          }};
}

void send(const std::vector<SpeedOrder>& orders) {
  for (const SpeedOrder& order : orders) {
    if (const auto* mode = std::get_if<SpeedMode>(&order.what)) {
      api::Vehicle::setSpeedMode(order.vehicle, static_cast<int>(*mode));
    } else {
      api::Vehicle::setSpeed(order.vehicle, std::get<double>(order.what));
    }
  }
}

void send(const std::vector<SteerOrder>& orders) {
  for (const SteerOrder& order : orders) {
    if (order.place) {
      const auto& [front, heading] = *order.place;
      api::Vehicle::moveToXY(order.vehicle, "", -1, front.x(), front.y(),
                             sumo_from_radians(heading), kExactPlace, kLaneReach);
    } else {
      api::Vehicle::remove(order.vehicle, libsumo::REMOVE_ARRIVED);
    }
  }
}

}  // namespace sumo_vehicle
}  // namespace pedzone
