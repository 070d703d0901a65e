// How fast a vehicle may drive before the people that pedzone walks: plans over plain values,
// without a call of SUMO.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "sumo/plan/vehicle.hpp"
#include "world/parameters.hpp"
#include "zone/crosswalks.hpp"

namespace pedzone {

/// A person as a vehicle sees it.
struct PersonAhead {
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();
  double radius = 0.24;
  std::optional<Crosswalk> crosswalk =
      {};                 ///< that it is on or about to enter, from where it comes
  double narrower = 0.0;  ///< [m] that the shoulders take off the radius as it holds them
  int exit_lane = -1;     ///< from the end of which SUMO walks it on; -1: of none
  bool crosses = false;   ///< a street, between the junctions
};

/// [m] from its front, at most: whom a vehicle may have to mind.
double reach_for_people(const FleetVehicle& vehicle, const Parameters& parameters);

/// Whether people are taken for as wide as with straight shoulders, or as they hold them now.
enum class BodyWidth { kStraight, kAsHeld };

/// The first person in a vehicle's way.
struct Obstruction {
  double distance = 0.0;  ///< [m] ≥ 0 the front may travel before the bodies touch
  double speed = 0.0;     ///< [m/s] of the person along the way; > 0 walks away
};

/// The first of `people` that the body will touch (with `margin` [m] at its sides) within
/// `distance` [m] along its way, where they stand now or where they will be in a moment.
std::optional<Obstruction> first_in_way(const FleetVehicle& vehicle,
                                        std::span<const PersonAhead> people, double margin,
                                        double distance, BodyWidth width = BodyWidth::kStraight);

/// What the vehicle's own car-following model finds safe [m/s] in the next step.
struct SafeSpeeds {
  /// Before somebody who stands `gap` [m] ahead.
  std::function<double(const FleetVehicle& vehicle, double gap)> stop;
  /// Behind somebody `gap` [m] ahead who goes on at `speed` [m/s].
  std::function<double(const FleetVehicle& vehicle, double gap, double speed)> follow;

  /// Before or behind that one, with `gap` [m] left to it.
  double before(const FleetVehicle& vehicle, const Obstruction& ahead, double gap) const;
};

/// The speed that a vehicle is told for the next step.
struct YieldOrder {
  double speed = 0.0;      ///< [m/s] ≥ 0
  bool emergency = false;  ///< it has to brake harder than it likes to
};

/// Towards a speed that is `safe` [m/s]: down no faster than the vehicle likes to brake, up the
/// more gently the harder it braked before.
YieldOrder comfortable_order(FleetVehicle& vehicle, double safe, double dt);

/// Looks for people as far ahead as the vehicle needs to stop from its speed v, braking as it likes
/// to, and v·1 s + yieldHorizon farther. Lets those on zebra crossings go first. Counts for how
/// long people hold it up: from creepAfter on it creeps. No order: nothing but its own traffic
/// holds it, and it is SUMO's. `dt` [s]: of the step.
std::optional<YieldOrder> plan_yield(FleetVehicle& vehicle, std::span<const PersonAhead> people,
                                     const Parameters& parameters, const SafeSpeeds& safe_speeds,
                                     double dt);

}  // namespace pedzone
