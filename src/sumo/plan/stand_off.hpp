// Vehicles and SUMO's own people that wait for each other for ever at a zone's border. SUMO stops
// a vehicle for anybody on a walking area before it, also for whom it would pass, and keeps people
// from a lane with a vehicle on it. Inside the zone people make way; there SUMO walks them.
#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "sumo/plan/vehicle_order.hpp"
#include "sumo/plan/yield_plan.hpp"
#include "zone/zone.hpp"

namespace pedzone {

class StandOffs {
 public:
  explicit StandOffs(const std::vector<Zone>& zones) : zones_(zones) {}

  /// Before SUMO's next step of `dt` [s]: lets a vehicle in or at a zone that has stood for
  /// creepAfter beside one of `people` (all near the zone) creep past, where its way is free of
  /// people and vehicles. To be called after Yielding::plan; vehicles that this holds are left
  /// alone.
  std::vector<SpeedOrder> plan(std::span<FleetVehicle> vehicles,
                               std::span<const PersonAhead> people, double dt);

 private:
  bool meets_zone(const FleetVehicle& vehicle) const;
  bool stands_off(const FleetVehicle& vehicle, std::span<const FleetVehicle> vehicles,
                  std::span<const PersonAhead> people) const;

  const std::vector<Zone>& zones_;
  std::unordered_map<std::string, double> stood_;  ///< [s]
  std::unordered_set<std::string> passing_;
};

}  // namespace pedzone
