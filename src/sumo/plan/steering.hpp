// Vehicles that follow the zone file's vehicle paths: where each is, step by step.
#pragma once

#include <functional>
#include <string>
#include <unordered_set>
#include <vector>

#include "sumo/plan/fleet.hpp"
#include "sumo/plan/vehicle_order.hpp"
#include "zone/vehicle_path.hpp"

namespace pedzone {

/// From the first row of its path to the last such a vehicle is where the path says, on a road or
/// not, and minds nobody; before, it is SUMO's. After the last row it leaves the simulation.
class Steering {
 public:
  explicit Steering(std::vector<VehiclePath> paths) : paths_(std::move(paths)) {}

  bool over() const { return paths_.empty(); }
  /// Ids of those on their way.
  const std::unordered_set<std::string>& steered() const { return steered_; }

  /// Where they are at `time` [s], by which SUMO's outputs name the next step. `present`: ids of
  /// all vehicles in SUMO. `length_of`: a vehicle's [m]. Throws InputError where one has not
  /// departed before its first row.
  std::vector<SteerOrder> plan(double time, const std::vector<std::string>& present,
                               const std::function<double(const std::string&)>& length_of);

  /// Gives those that are steered the motion of their paths in the step of `dt` [s] that ends at
  /// `time` [s]: SUMO knows neither how fast they are beyond their type's limits nor their way.
  void foresee(Fleet& fleet, double time, double dt) const;

 private:
  std::vector<VehiclePath> paths_;  ///< that are not over
  std::unordered_set<std::string> steered_;
};

}  // namespace pedzone
