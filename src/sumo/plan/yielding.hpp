// Vehicles give way to the people that pedzone walks: what each is told, and when it is given back.
#pragma once

#include <span>
#include <string>
#include <unordered_set>

#include "sumo/plan/vehicle_order.hpp"
#include "sumo/plan/yield_plan.hpp"
#include "zone/zone.hpp"

namespace pedzone {

class Yielding {
 public:
  explicit Yielding(const std::vector<Zone>& zones) : zones_(zones) {}

  /// The speed that each vehicle takes in the next step of `dt` [s], by its plan (yield_plan.hpp);
  /// those that no longer need one are given back.
  std::vector<SpeedOrder> plan(std::span<FleetVehicle> vehicles,
                               std::span<const PersonAhead> people, const SafeSpeeds& safe_speeds,
                               double dt);

  /// Ids of all vehicles that ever gave way.
  const std::unordered_set<std::string>& yielded() const { return yielded_; }

 private:
  void command(FleetVehicle& vehicle, const YieldOrder& order, std::vector<SpeedOrder>& out);
  void give_back(FleetVehicle& vehicle, std::vector<SpeedOrder>& out);

  const std::vector<Zone>& zones_;
  std::unordered_set<std::string> held_, yielded_, in_emergency_;
};

}  // namespace pedzone
