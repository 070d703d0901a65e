// What pedzone has told vehicles and they still go by. All of it is taken back when pedzone leaves
// a SUMO that runs on.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "sumo/plan/vehicle_order.hpp"

namespace pedzone {

class Told {
 public:
  /// What SUMO is told for its next step.
  void note(std::span<const SpeedOrder> orders);

  /// That id stands for another vehicle from now on, or for none.
  void forget(const std::string& vehicle) { last_.erase(vehicle); }

  /// [m/s] that a vehicle was told last; nothing: it has its own.
  std::optional<double> speed(const std::string& vehicle) const;

  /// The orders that give each of the vehicles back to SUMO, in the order of their ids; those of
  /// which SUMO has none any more are left out.
  std::vector<SpeedOrder> take_back(const std::vector<std::string>& present) const;

 private:
  struct Last {
    double speed = kOwnSpeed;
    SpeedMode mode = SpeedMode::kOwn;
    LaneChanges changes = LaneChanges::kOwn;

    bool operator==(const Last&) const = default;
  };
  std::unordered_map<std::string, Last> last_;  ///< by vehicle
};

}  // namespace pedzone
