// The vehicles in or near the zones: what is made of what SUMO tells of them in each step.
#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/near_points.hpp"
#include "sumo/plan/way_ahead.hpp"
#include "world/snapshot.hpp"

namespace pedzone {

class Fleet {
 public:
  /// The network must outlive it.
  Fleet(const Network& network, const std::vector<Zone>& zones);

  /// Whether a vehicle with its front at `point` [m] belongs to it: within 60 m of a zone (150 m
  /// where people cross streets anywhere), or as far as it needs to stop where it drives fast or on
  /// ice.
  bool near_zone(const Vec2& point) const;
  /// The same of one with its front and its rear at these points [m].
  bool near_zone(const Vec2& front, const Vec2& rear) const;
  /// Those of `states` with any of their body near that zone.
  std::vector<VehicleState> states_near(std::size_t zone,
                                        std::span<const VehicleState> states) const;
  /// (0, 1] the share of their deceleration that the weather leaves to vehicles.
  double grip() const { return grip_; }

  /// Takes in the vehicles near a zone, in SUMO's order, after a step of `dt` [s]. How long people
  /// have held one up, and what it was told, carries over.
  void update(std::vector<VehicleSeen> seen, double dt);
  /// Before update(): in the step that vehicle departed or arrived.
  void forget(const std::string& vehicle) { replaced_.insert(vehicle); }
  /// Before update(): in the step SUMO put that vehicle elsewhere. What it was told carries over.
  void teleport(const std::string& vehicle) { teleported_.insert(vehicle); }

  std::vector<FleetVehicle>& vehicles() { return vehicles_; }
  const std::vector<FleetVehicle>& vehicles() const { return vehicles_; }

  /// The same as the crowd sees them, moving as they will in the next `dt` [s]. Of one that bends
  /// each part is there, with the key of the whole.
  void states(double dt, std::vector<VehicleState>& out) const;

  /// As WayAhead::beside.
  std::vector<Polyline> ways_beside(const FleetVehicle& vehicle, double soon,
                                    double distance) const {
    return ways_.beside(vehicle, soon, distance);
  }

  /// Whether a body of `radius` [m] at a point overlaps a vehicle.
  bool touches(const Vec2& point, double radius) const;
  /// Whether a moving vehicle will sweep within `margin` [m] of a point in the next `horizon` [s].
  bool approaches(const Vec2& point, double margin, double horizon) const;
  /// A vehicle within `margin` [m] that waits in traffic, not at a stop of its own; null: none.
  const FleetVehicle* waiting_beside(const Vec2& point, double margin) const;

 private:
  void share_junctions();
  void note_places();
  void find_leaders();
  std::vector<std::uint32_t> near(const Vec2& place, double reach) const;

  const Network& network_;
  WayAhead ways_;
  double grip_ = 1.0;
  std::vector<Box> boxes_;  ///< zones' bounds, grown
  std::vector<FleetVehicle> vehicles_, previous_;
  std::unordered_map<std::string, std::size_t> previous_index_;
  std::unordered_set<std::string> replaced_, teleported_;  ///< ids, in the last step
  NearPoints fronts_;
  double longest_ = 0.0, widest_ = 0.0;  ///< [m] of them
};

}  // namespace pedzone
