// The way that a vehicle takes: its route's last and next lanes as a line.
#pragma once

#include <optional>
#include <vector>

#include "sumo/plan/vehicle.hpp"
#include "zone/zone.hpp"

namespace pedzone {

class WayAhead {
 public:
  /// The network must outlive it.
  WayAhead(const Network& network, const std::vector<Zone>& zones);

  /// Whether a vehicle on that lane is over or below the zones.
  bool is_apart(int lane) const { return lane >= 0 && apart_[lane]; }

  /// Sets by which lanes a vehicle came to its present one, from what was known a step before.
  void remember(const FleetVehicle& before, FleetVehicle& vehicle) const;

  /// Sets the vehicle's way, whether its trip ends there, at which crossings it gives way to
  /// people, its first junction and its zone. The way begins at the rear and follows the lanes that
  /// it came by; if these do not fit its heading, it is straight. The way ends `distance` [m]
  /// beyond the front, with the route, or where it comes to a lane over or below the zones. If the
  /// vehicle is on no lane, the way goes straight on. The zone is the first one on the way; if
  /// there is none, the first of all.
  void look(FleetVehicle& vehicle, double distance) const;

  /// The ways that it would take from the lanes beside it, if it changed to one of them within the
  /// next `soon` [m] of its way: SUMO puts it there from one step to the next. As its own way, from
  /// the rear to `distance` [m] beyond the front.
  std::vector<Polyline> beside(const FleetVehicle& vehicle, double soon, double distance) const;

 private:
  /// A lane, and how far [m] to the left of it one drives.
  struct Beside {
    int lane;
    double aside;
  };
  std::vector<Beside> neighbours(int lane) const;
  /// Where on its lane one that changes lanes bit by bit will drive on.
  struct Drift {
    double lateral;  ///< [m] beside its lane's middle, to the left
    double way;      ///< [m] until it is there
  };
  std::optional<Drift> drift_ahead(const FleetVehicle& vehicle, double offset) const;
  double append_drift(const FleetVehicle& vehicle, double& offset, double& left,
                      Polyline& way) const;
  void append_way(const Beside& from, const VehicleSeen& vehicle, int index, double offset,
                  double left, Polyline& way) const;
  int junction_after(std::span<const int> route, int index) const;
  Polyline way_behind(const FleetVehicle& vehicle, double offset) const;
  bool is_internal(int lane) const;
  double way_inside(const FleetVehicle& vehicle, double offset) const;
  const Connection* leading(int lane, int edge, std::span<const int> means) const;
  int next_lane(int lane, const VehicleSeen& vehicle, int& index) const;

  const Network& network_;
  std::vector<bool> apart_;                         ///< of each lane
  std::vector<int> zone_of_lane_;                   ///< -1: in no zone
  std::vector<std::vector<int>> connections_from_;  ///< per lane: indices of Network::connections
};

}  // namespace pedzone
