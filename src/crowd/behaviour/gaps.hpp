// Gaps between vehicles: whether somebody gets across a street before the next ones come.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>

#include "crowd/sense/street_traffic.hpp"

namespace pedzone {

/// A walk straight across a street, at s.
struct CrossingWalk {
  double s = 0.0;         ///< [m]
  double drift = 0.0;     ///< [m] s on the other side less s
  double from = 0.0;      ///< [m] t where the body is
  double to = 0.0;        ///< [m] t where the ground on the other side begins, or of a refuge
  double radius = 0.24;   ///< [m] of the body
  double speed = 1.34;    ///< [m/s] > 0
  double start_up = 0.0;  ///< [s] until it walks
  double margin = 0.0;    ///< [s] left before a vehicle comes
  bool insists = false;   ///< steps out before vehicles that can stop in comfort
};

/// What vehicles mean for a walk across.
struct GapView {
  bool enough = true;
  bool barred = false;                                    ///< by a vehicle that stands on the line
  double next = std::numeric_limits<double>::infinity();  ///< [s] until the next one that counts
  std::uint64_t vehicle = 0;                              ///< its key; 0: none
};

/// Near and far lanes each by their own time: a person has to have left the width that a vehicle
/// covers `margin` before it comes, or enters that after it has passed ("rolling gap"). Vehicles
/// that `sees` says no to do not count; without it all do.
GapView look_at_gap(std::span<const StreetVehicle> traffic, std::span<const VehicleState> vehicles,
                    const CrossingWalk& walk,
                    const std::function<bool(std::uint32_t vehicle)>& sees = {});

/// What who is on the carriageway does about vehicles that come.
struct Passage {
  bool committed = false;  ///< it is where vehicles drive
  double hurry = 1.0;      ///< share of its speed that gets it past them in time
  double room = std::numeric_limits<double>::infinity();  ///< [m] to go before it lets one pass
  /// [m] to go before it comes to a vehicle that stands on its line
  double standing = std::numeric_limits<double>::infinity();

  bool barred() const { return standing < std::numeric_limits<double>::infinity(); }
};

/// As look_at_gap(), for who is on its way. Where vehicles drive already, it hurries, by at most
/// `fastest` times its speed, or stands between the lanes. Before, as beside parked cars, it stands
/// until there is a gap as at the kerb.
Passage pass_vehicles(const StreetTraffic& traffic, const CrossingWalk& walk, double fastest,
                      const std::function<bool(std::uint32_t vehicle)>& sees);

/// [s] width / speed + start-up + margin: the gap that a person needs on an empty street
/// (Highway Capacity Manual 2010, chapter 19: 3 s of start-up and clearance).
double critical_gap(const CrossingWalk& walk);

/// [s] that a person waits on average for a gap of `needed` [s] in random traffic of `flow` [1/s]
/// (Adams 1936; Highway Capacity Manual 2010, chapter 19).
double expected_wait(double flow, double needed);

}  // namespace pedzone
