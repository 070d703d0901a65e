// How often vehicles come to a stand.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <unordered_map>

#include "conflict/tracker.hpp"

namespace pedzone::study {

/// [m/s] assumed: a vehicle is under way again at walking pace. SUMO's own waitingCount takes every
/// crossing of 0.1 m/s for a stop, and counts dozens where a vehicle creeps.
inline constexpr double kUnderWay = 1.0;

class VehicleStops {
 public:
  /// Takes in a step. Who has been under way and stands (kHaltingSpeed) has come to a stand.
  void step(std::span<const VehicleSample> vehicles);
  /// Of all vehicles, in all; planned ones too.
  std::size_t count() const { return count_; }

 private:
  std::unordered_map<std::string, bool> under_way_;  ///< by id
  std::size_t count_ = 0;
};

}  // namespace pedzone::study
