// Vehicles give way to the people that pedzone walks: sends the plans (yield_plan.hpp) to SUMO,
// whose car-following models say what is safe.
#pragma once

#include <span>
#include <string>
#include <unordered_set>

#include "sumo/live/fleet.hpp"
#include "sumo/live/yield_plan.hpp"

namespace pedzone {

class Yielding {
 public:
  explicit Yielding(const std::vector<Zone>& zones) : zones_(zones) {}

  /// Sets the speed that each vehicle takes in the next step of `dt` [s]; gives back those that
  /// no longer need it.
  void apply(Fleet& fleet, std::span<const PersonAhead> people, double dt);

  /// Ids of all vehicles that ever gave way.
  const std::unordered_set<std::string>& yielded() const { return yielded_; }

 private:
  void command(FleetVehicle& vehicle, const YieldOrder& order);
  void give_back(FleetVehicle& vehicle);

  const std::vector<Zone>& zones_;
  std::unordered_set<std::string> held_, yielded_, in_emergency_;
};

}  // namespace pedzone
