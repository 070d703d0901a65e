// Reads the vehicles near the zones after each step.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "sumo/calls/vehicles.hpp"
#include "sumo/plan/fleet.hpp"
#include "sumo/plan/told.hpp"

namespace pedzone {

class VehicleReader {
 public:
  /// Both must outlive it.
  VehicleReader(const Network& network, SumoVehicles& sumo) : network_(network), sumo_(sumo) {}

  /// Those that belong to the fleet, in SUMO's order, and those far away that pedzone has told a
  /// speed (they were moved there): they are to be given back. Where the weather leaves them less
  /// grip, one that is new is told to brake less, whatever it brakes for.
  std::vector<VehicleSeen> read(const Fleet& fleet, const Told& told);

 private:
  const VehicleTraits& traits(const std::string& id, double grip);
  const std::vector<int>& route(const std::string& id);

  const Network& network_;
  SumoVehicles& sumo_;
  std::unordered_map<std::string, VehicleTraits> traits_;     ///< what does not change
  std::unordered_map<std::string, std::vector<int>> routes_;  ///< by SUMO's route id
};

}  // namespace pedzone
