// Vehicles give way to the people that pedzone walks: each asks its own SUMO car-following model
// for the safe speed before the nearest person in its way.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <unordered_set>

#include "sumo/fleet.hpp"

namespace pedzone {

/// A person as a vehicle sees it.
struct PersonAhead {
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();
  double radius = 0.24;
};

/// The first person in a vehicle's way.
struct Obstruction {
  double distance = 0.0;     ///< [m] ≥ 0 the front may travel before the bodies touch
  double speed = 0.0;        ///< [m/s] of the person along the way; > 0 walks away
  double gap_to_body = 0.0;  ///< [m] clearance now
};

/// The first of `people` that the body will touch (with `margin` [m] at its sides) within
/// `distance` [m] along its way, where they stand now or where they will be in a moment.
std::optional<Obstruction> first_in_way(const FleetVehicle& vehicle,
                                        std::span<const PersonAhead> people, double margin,
                                        double distance);

class Yielding {
 public:
  explicit Yielding(const std::vector<Zone>& zones) : zones_(zones) {}

  /// Sets the speed that each vehicle takes in the next step of `dt` [s]; gives back those that
  /// no longer need it.
  void apply(Fleet& fleet, std::span<const PersonAhead> people, double dt);

  /// Ids of all vehicles that ever gave way.
  const std::unordered_set<std::string>& yielded() const { return yielded_; }

 private:
  void yield(FleetVehicle& vehicle, std::span<const PersonAhead> people, double dt);
  double safe_speed(const FleetVehicle& vehicle, const Obstruction& ahead, double dt) const;
  void command(FleetVehicle& vehicle, double speed, bool emergency);
  void give_back(FleetVehicle& vehicle);

  const std::vector<Zone>& zones_;
  std::unordered_set<std::string> held_, yielded_, in_emergency_;
};

}  // namespace pedzone
