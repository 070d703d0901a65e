// Vehicles give way to the people that pedzone walks: what each is told, and when it is given back.
#pragma once

#include <span>
#include <string>
#include <unordered_map>
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

  /// The vehicle has run into somebody, or still overlaps whom it did. Whether it gives way to
  /// people or not, it brakes as hard as it can until it stands, and stands for 5 s. Those that
  /// others drive and those on a path of the zone file are not touched.
  void stop(const std::string& vehicle) { stopping_[vehicle] = 0.0; }

  /// Ids of all vehicles that ever gave way.
  const std::unordered_set<std::string>& yielded() const { return yielded_; }

 private:
  void command(FleetVehicle& vehicle, const YieldOrder& order, std::vector<SpeedOrder>& out);
  std::optional<YieldOrder> plan_stop(const FleetVehicle& vehicle, double dt);
  void give_back(FleetVehicle& vehicle, std::vector<SpeedOrder>& out);

  const std::vector<Zone>& zones_;
  std::unordered_set<std::string> held_, yielded_, in_emergency_;
  std::unordered_map<std::string, double> stopping_;  ///< [s] for which it stands already
};

}  // namespace pedzone
