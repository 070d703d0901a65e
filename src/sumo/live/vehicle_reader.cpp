#include "sumo/live/vehicle_reader.hpp"

#include "sumo/files/truth.hpp"
#include "sumo/plan/zone_route.hpp"

namespace pedzone {

const VehicleTraits& VehicleReader::traits(const std::string& id, double grip) {
  const auto [entry, is_new] = traits_.try_emplace(id);
  VehicleTraits& traits = entry->second;
  if (is_new) {
    sumo_.read_body(id, traits);
    if (grip < 1.0) {  // on a slippery road neither SUMO nor we may brake as on a dry one
      traits.decel *= grip;
      traits.emergency_decel *= grip;
      sumo_.set_braking(id, traits.decel, traits.emergency_decel);
    }
    traits.yields = !is_false(sumo_.parameter(id, "pedzone.yield"));
    traits.external = is_true(sumo_.parameter(id, "pedzone.external"));
    traits.electric = is_true(sumo_.parameter(id, "pedzone.electric"));
  }
  return traits;
}

const std::vector<int>& VehicleReader::route(const std::string& id) {
  const auto [entry, is_new] = routes_.try_emplace(sumo_.route_id(id));
  if (is_new) entry->second = edge_indices(network_, sumo_.route(id));
  return entry->second;
}

std::vector<VehicleSeen> VehicleReader::read(const Fleet& fleet, const Told& told) {
  std::vector<VehicleSeen> seen;
  for (const std::string& id : sumo_.ids()) {
    const auto front = sumo_.front(id);
    if (!front || !(fleet.near_zone(*front) || told.speed(id))) continue;
    VehicleSeen vehicle;
    vehicle.id = id;
    vehicle.traits = traits(id, fleet.grip());
    vehicle.front = *front;
    vehicle.heading = sumo_.heading(id);
    vehicle.speed = sumo_.speed(id);
    vehicle.own_speed = sumo_.own_speed(id);
    vehicle.allowed_speed = sumo_.allowed_speed(id);
    vehicle.time_loss = sumo_.time_loss(id);
    vehicle.horn = is_true(sumo_.parameter(id, "pedzone.horn"));
    vehicle.invites = sumo_.parameter(id, "pedzone.signal") == "after-you";
    vehicle.stopped = sumo_.is_at_stop(id);
    const auto lane = network_.lane_index.find(sumo_.lane(id));
    if (lane != network_.lane_index.end()) {
      vehicle.lane = lane->second;
      vehicle.lateral = sumo_.lateral(id);
      vehicle.route = route(id);
      vehicle.route_index = sumo_.route_index(id);
    }
    seen.push_back(std::move(vehicle));
  }
  return seen;
}

}  // namespace pedzone
