// What vehicles have been told and still go by: all of it is taken back when pedzone leaves a SUMO
// that runs on.
#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "sumo/plan/vehicle_order.hpp"

namespace pedzone {

class Told {
 public:
  void note(std::span<const SpeedOrder> orders);

  /// The orders that give each of the vehicles back to SUMO, in the order of their ids; those of
  /// which SUMO has none any more are left out.
  std::vector<SpeedOrder> take_back(const std::vector<std::string>& present) const;

 private:
  struct Last {
    double speed = kOwnSpeed;
    SpeedMode mode = SpeedMode::kDefault;
    LaneChanges changes = LaneChanges::kOwn;

    bool operator==(const Last&) const = default;
  };
  std::unordered_map<std::string, Last> last_;  ///< by vehicle
};

}  // namespace pedzone
