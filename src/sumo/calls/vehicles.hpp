// What is read of vehicles in SUMO, and what they are told: calls, and no decision.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sumo/plan/vehicle_order.hpp"
#include "sumo/plan/yield_plan.hpp"

namespace pedzone {

class SumoVehicles {
 public:
  virtual ~SumoVehicles() = default;

  virtual std::vector<std::string> ids() const = 0;  ///< of all in SUMO
  /// Who departed or arrived in SUMO's last step: an id now stands for another vehicle, or for
  /// none.
  virtual std::vector<std::string> new_or_gone() const = 0;
  /// Who came back from a teleport in SUMO's last step.
  virtual std::vector<std::string> teleported() const = 0;
  /// Who should have departed, and found no room on the road yet; in SUMO's order.
  virtual std::vector<std::string> pending() const = 0;
  virtual std::optional<Vec2> front(const std::string& id) const = 0;  ///< [m] none: it teleports
  virtual double heading(const std::string& id) const = 0;             ///< [rad]
  virtual double speed(const std::string& id) const = 0;               ///< [m/s] ≥ 0
  /// [m/s] ≥ 0 if no client had told it anything
  virtual double own_speed(const std::string& id) const = 0;
  virtual double allowed_speed(const std::string& id) const = 0;  ///< [m/s]
  virtual double time_loss(const std::string& id) const = 0;      ///< [s]
  virtual std::string edge(const std::string& id) const = 0;
  virtual std::string lane(const std::string& id) const = 0;
  /// [m] beside its lane's middle: to the left where vehicles drive on the right, else to the right
  virtual double lateral(const std::string& id) const = 0;
  virtual std::string route_id(const std::string& id) const = 0;
  virtual std::vector<std::string> route(const std::string& id) const = 0;  ///< edges
  virtual int route_index(const std::string& id) const = 0;                 ///< its edge's, in that
  /// The lanes that SUMO means it to take, from its own on, or from the one that it has to change
  /// to; nothing inside a junction.
  virtual std::vector<std::string> lanes_ahead(const std::string& id) const = 0;
  virtual bool is_at_stop(const std::string& id) const = 0;  ///< of its own, parking included
  virtual bool is_parked(const std::string& id) const = 0;   ///< at such a stop beside the road
  virtual double length(const std::string& id) const = 0;    ///< [m]
  /// Its sizes, decelerations and acceleration; the rest is left as it is.
  virtual void read_body(const std::string& id, VehicleTraits& traits) const = 0;
  /// Id of its type. Where a program has changed one vehicle, it has one of its own: TYPE@VEHICLE.
  virtual std::string type(const std::string& id) const = 0;
  /// Its own parameter, else that of its type.
  virtual std::string parameter(const std::string& id, const std::string& key) const = 0;

  /// That id stands for another vehicle from now on, or for none.
  virtual void forget(const std::string& id) = 0;
  /// It brakes with no more than these from now on, whatever it brakes for.
  virtual void set_braking(const std::string& id, double decel, double emergency_decel) = 0;
  /// What the vehicle's own car-following model finds safe.
  virtual SafeSpeeds safe_speeds() const = 0;
  virtual void send(const std::vector<SpeedOrder>& orders) = 0;
  virtual void send(const std::vector<SteerOrder>& orders) = 0;
};

}  // namespace pedzone
