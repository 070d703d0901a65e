#include "sumo/plan/told.hpp"

#include <algorithm>

namespace pedzone {

void Told::note(std::span<const SpeedOrder> orders) {
  for (const SpeedOrder& order : orders) {
    Last& last = last_[order.vehicle];
    if (const auto* speed = std::get_if<double>(&order.what)) {
      last.speed = *speed < 0.0 ? kOwnSpeed : *speed;
    } else if (const auto* mode = std::get_if<SpeedMode>(&order.what)) {
      last.mode = *mode;
    } else {
      last.changes = std::get<LaneChanges>(order.what);
    }
    if (last == Last{}) last_.erase(order.vehicle);
  }
}

std::optional<double> Told::speed(const std::string& vehicle) const {
  const auto found = last_.find(vehicle);
  if (found == last_.end() || found->second.speed < 0.0) return std::nullopt;
  return found->second.speed;
}

std::vector<SpeedOrder> Told::take_back(const std::vector<std::string>& present) const {
  std::vector<std::string> vehicles;
  for (const std::string& id : present) {
    if (last_.contains(id)) vehicles.push_back(id);
  }
  std::ranges::sort(vehicles);
  std::vector<SpeedOrder> orders;
  for (const std::string& id : vehicles) {
    const Last& last = last_.at(id);
    if (last.mode != SpeedMode::kOwn) orders.push_back({id, SpeedMode::kOwn});
    if (last.changes != LaneChanges::kOwn) orders.push_back({id, LaneChanges::kOwn});
    if (last.speed >= 0.0) orders.push_back({id, kOwnSpeed});
  }
  return orders;
}

}  // namespace pedzone
