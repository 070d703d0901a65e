// Vehicles do not change lanes onto people. SUMO does not see those whom pedzone walks, and puts a
// vehicle from one lane onto the other within a step.
#pragma once

#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "sumo/plan/fleet.hpp"
#include "sumo/plan/people_near.hpp"
#include "sumo/plan/vehicle_order.hpp"
#include "zone/zone.hpp"

namespace pedzone {

class LaneKeeping {
 public:
  explicit LaneKeeping(const std::vector<Zone>& zones) : zones_(zones) {}

  /// Before SUMO's next step of `dt` [s]: a vehicle that gives way to people is told to keep its
  /// lane as long as somebody is on a lane beside it where its body would be, or nearer ahead than
  /// it could stop for as it likes to brake; or could be there within the step, of who crosses a
  /// street. One that changes lanes bit by bit keeps it for people between the lanes, too, and for
  /// those whom it would come to in 3.5 s more. After that, and once it is not in the fleet any
  /// more, it may change lanes as before.
  std::vector<SpeedOrder> plan(const Fleet& fleet, const PeopleNear& people, double dt);

 private:
  bool is_anybody_beside(const Fleet& fleet, const FleetVehicle& vehicle, const PeopleNear& all,
                         double dt) const;

  const std::vector<Zone>& zones_;
  std::unordered_set<std::string> keep_;  ///< vehicles that were told to
};

}  // namespace pedzone
