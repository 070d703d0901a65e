// What SUMO is told of a vehicle: plain values, sent by calls/vehicles.cpp.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vec.hpp"

namespace pedzone {

/// What SUMO itself minds when a vehicle is told a speed (bits of SUMO's speed mode).
enum class SpeedMode {
  kOwn = -1,        ///< as before it was told another
  kEmergency = 27,  ///< all but the bound of comfortable braking
  kPass = 63,       ///< all but who is inside the junction already
};

/// Whether a vehicle may change lanes.
enum class LaneChanges {
  kNone,
  kOwn,  ///< as before it was told not to
};

/// One call: a speed [m/s] for the next step (negative: the vehicle is SUMO's again), or a mode.
struct SpeedOrder {
  std::string vehicle;
  std::variant<double, SpeedMode, LaneChanges> what;

  bool operator==(const SpeedOrder&) const = default;
};

constexpr double kOwnSpeed = -1.0;  ///< gives a vehicle's speed back to SUMO

/// Where a steered vehicle is put; without a place it leaves the simulation.
struct SteerOrder {
  struct Place {
    Vec2 front;      ///< [m]
    double heading;  ///< [rad]
  };
  std::string vehicle;
  std::optional<Place> place;
};

}  // namespace pedzone
