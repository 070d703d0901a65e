// Vehicles that follow the zone file's vehicle paths: SUMO is told where each is, step by step.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "sumo/files/scenario.hpp"
#include "sumo/live/fleet.hpp"
#include "zone/vehicle_path.hpp"

namespace pedzone {

/// From the first row of its path to the last such a vehicle is where the path says, on a road or
/// not, and minds nobody; before, it is SUMO's. After the last row it leaves the simulation.
class Steering {
 public:
  /// Throws InputError for a path of a vehicle that the scenario's files do not name.
  Steering(const Scenario& scenario, std::vector<VehiclePath> paths);

  /// Has SUMO put them where they are at `time` [s], by which its outputs name the next step.
  /// Throws InputError where one has not departed before its first row.
  void apply(double time);

  /// Gives those that are steered the motion of their paths in the step of `dt` [s] that ends at
  /// `time` [s]: SUMO knows neither how fast they are beyond their type's limits nor their way.
  void foresee(Fleet& fleet, double time, double dt) const;

 private:
  void put(const VehiclePath& path, double time);

  std::vector<VehiclePath> paths_;  ///< that are not over
  std::set<std::string> steered_;   ///< ids of those on their way
};

}  // namespace pedzone
