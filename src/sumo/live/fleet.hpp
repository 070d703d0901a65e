// The vehicles in or near the zones: read from SUMO each step, with the way that each will take.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "world/snapshot.hpp"
#include "zone/lane_geometry.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// What does not change during a vehicle's life.
struct VehicleTraits {
  double length = 5.0, width = 1.8;                        ///< [m]
  double decel = 4.5, emergency_decel = 9.0, accel = 2.6;  ///< [m/s²] > 0
  bool yields = true;     ///< vType or vehicle parameter pedzone.yield
  bool external = false;  ///< parameter pedzone.external: perceived, never touched
  bool electric = false;  ///< parameter pedzone.electric: no engine is heard
};

/// A vehicle near a zone.
struct FleetVehicle {
  std::string id;
  VehicleTraits traits;
  Vec2 front = Vec2::Zero();     ///< [m] middle of the front bumper
  double heading = 0.0;          ///< [rad]
  double speed = 0.0;            ///< [m/s] ≥ 0
  double allowed_speed = 0.0;    ///< [m/s] what it may drive here
  bool stopped = false;          ///< at a stop of its own (also parking)
  Vec2 velocity = Vec2::Zero();  ///< [m/s] from its last two places: reversing and side-slip too
  double yaw_rate = 0.0;         ///< [rad/s] of a steered one (steering.hpp)
  Polyline way;                  ///< [m] from its rear along its own next lanes
  int zone = 0;                  ///< index of the zone it is in or comes to first
  double commanded = -1.0;       ///< [m/s] speed set by us for the next step; -1: SUMO's own
  double held_up = 0.0;          ///< [s] how long people have held it up
  double slowed = 0.0;           ///< [s] people have made it slower without a break
  double claim = 0.0;            ///< [m] see VehicleState
  bool creeping = false;
  bool horn = false;     ///< parameter pedzone.horn of it or its vType is true at present
  bool invites = false;  ///< pedzone.signal is after-you at present

  Vec2 centre() const { return front - unit(heading) * (0.5 * traits.length); }
};

/// The part of the plane that a vehicle's rectangle covers.
struct Body {
  Vec2 centre;
  Vec2 axis;                       ///< unit vector, forward
  double half_length, half_width;  ///< [m]
  /// Distance [m] from a point to the rectangle; negative inside (depth to the nearest side).
  double distance(const Vec2& point) const;
};

Body body_of(const FleetVehicle& vehicle);

/// The body after the front has gone `travelled` [m] along the way: from rear to front bumper as a
/// chord of the way, so that corners are cut as SUMO draws them.
Body body_after(const FleetVehicle& vehicle, double travelled);

class Fleet {
 public:
  Fleet(const Network& network, const std::vector<Zone>& zones);

  /// Reads SUMO's vehicles after a step of `dt` [s]. Those near a zone are kept, in SUMO's order;
  /// held_up and creeping carry over.
  void read(double dt);

  std::vector<FleetVehicle>& vehicles() { return vehicles_; }
  const std::vector<FleetVehicle>& vehicles() const { return vehicles_; }

  /// The same as the crowd sees them, moving as they will in the next `dt` [s].
  void states(double dt, std::vector<VehicleState>& out) const;

  /// Whether a body of `radius` [m] at a point overlaps a vehicle.
  bool touches(const Vec2& point, double radius) const;
  /// Whether a moving vehicle will sweep within `margin` [m] of a point in the next `horizon` [s].
  bool approaches(const Vec2& point, double margin, double horizon) const;
  /// A vehicle within `margin` [m] that waits in traffic, not at a stop of its own; null: none.
  const FleetVehicle* waiting_beside(const Vec2& point, double margin) const;

 private:
  bool near_zone(const Vec2& point) const;
  const VehicleTraits& traits(const std::string& id);
  void reduce_braking(const std::string& id, VehicleTraits& traits) const;
  const std::vector<int>& route(const std::string& id);
  /// Sets way and zone.
  void look_ahead(FleetVehicle& vehicle, double distance);
  int next_lane(int lane, const std::vector<int>& route, int& index) const;

  const Network& network_;
  double grip_ = 1.0;  ///< share of their deceleration that the weather leaves to vehicles
  std::vector<int> zone_of_lane_;                   ///< -1: in no zone
  std::vector<std::pair<Vec2, Vec2>> boxes_;        ///< zones' bounds, grown
  std::vector<std::vector<int>> connections_from_;  ///< per lane: indices of Network::connections
  std::vector<FleetVehicle> vehicles_, previous_;
  std::unordered_map<std::string, std::size_t> previous_index_;
  std::unordered_map<std::string, VehicleTraits> traits_;
  std::unordered_map<std::string, std::vector<int>> routes_;  ///< by SUMO's route id
};

}  // namespace pedzone
