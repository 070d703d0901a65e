// Who would wait for each other for ever by SUMO's rules.
// Vehicles and SUMO's own people at a zone's border: SUMO stops a vehicle for anybody on a walking
// area before it, also for whom it would pass, and keeps people from a lane with a vehicle on it,
// and from a crossing before one that means to drive. Inside the zone people make way; there SUMO
// walks them.
// Vehicles inside a junction whose ways join: one stops for the other, which has the right of way,
// and that one for the first, which is ahead of it. Among SUMO's own vehicles nobody comes so late;
// but people hold some of them.
#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "sumo/plan/vehicle_order.hpp"
#include "sumo/plan/yield_plan.hpp"
#include "zone/zone.hpp"

namespace pedzone {

class StandOffs {
 public:
  explicit StandOffs(const std::vector<Zone>& zones) : zones_(zones) {}

  /// Before SUMO's next step of `dt` [s]: what a vehicle in or at a zone is told that has stood for
  /// creepAfter beside one of `people` (all near the zone), or with others in a junction where all
  /// stand; before lights after 120 s, and between these nobody is let go. Where its way is free of
  /// people and vehicles it creeps past, out of the junction and by its length and 5 m. If SUMO
  /// keeps it standing for 2 s all the same, it waits again: it may find a gap with its own speed
  /// that it does not with this one. Where somebody stands in its way it lets people go first, for
  /// creepAfter at most before it waits again: while it is told to stand, SUMO opens crossings to
  /// them, and pedzone gives people back beside it. To be called after Yielding::plan; vehicles
  /// that this slows down are left alone, those that it lets drive while SUMO has them stand are
  /// not. A vehicle that meanwhile has gone (it teleports), or is driven by another program, gets
  /// its own speed back as soon as it is among `vehicles` again and pedzone's to tell.
  std::vector<SpeedOrder> plan(std::span<FleetVehicle> vehicles,
                               std::span<const PersonAhead> people, double dt);

  /// That id stands for another vehicle from now on, or for none.
  void forget(const std::string& vehicle) { stand_offs_.erase(vehicle); }

 private:
  enum class Way { kWait, kPass, kLetGo };
  struct StandOff {
    double stood = 0.0;   ///< [s]
    double tried = 0.0;   ///< [s] on the present way, without getting on
    double passed = 0.0;  ///< [m] that it has crept past
    Way way = Way::kWait;
  };

  bool meets_zone(const FleetVehicle& vehicle) const;
  Way way_out(const FleetVehicle& vehicle, std::span<const FleetVehicle> vehicles,
              std::span<const PersonAhead> people) const;
  Way go_on(StandOff& one, const FleetVehicle& vehicle, Way out, double dt) const;
  void tell(FleetVehicle& vehicle, Way before, Way now, bool commanded, double dt,
            std::vector<SpeedOrder>& orders) const;

  const std::vector<Zone>& zones_;
  std::unordered_map<std::string, StandOff> stand_offs_;  ///< by vehicle
};

}  // namespace pedzone
