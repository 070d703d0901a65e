// What is read of vehicles in SUMO, and what they are told: calls, and no decision.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "sumo/plan/fleet.hpp"
#include "sumo/plan/vehicle_order.hpp"
#include "sumo/plan/yield_plan.hpp"

namespace pedzone {

/// Reads vehicles after each step. Keeps what does not change.
class VehicleReader {
 public:
  /// The network must outlive it.
  explicit VehicleReader(const Network& network) : network_(network) {}

  /// Those that belong to the fleet, in SUMO's order. Where the weather leaves them less grip, one
  /// that is new is told to brake less, whatever it brakes for.
  std::vector<VehicleSeen> read(const Fleet& fleet);

 private:
  const VehicleTraits& traits(const std::string& id, double grip);
  const std::vector<int>& route(const std::string& id);

  const Network& network_;
  std::unordered_map<std::string, VehicleTraits> traits_;
  std::unordered_map<std::string, std::vector<int>> routes_;  ///< by SUMO's route id
};

namespace sumo_vehicle {

std::vector<std::string> ids();                    ///< of all in SUMO
double length(const std::string& id);              ///< [m]
std::optional<Vec2> front(const std::string& id);  ///< [m] nothing while it teleports
std::string edge(const std::string& id);
bool is_at_stop(const std::string& id);  ///< of its own, parking included
/// What the vehicle's own car-following model finds safe.
SafeSpeeds safe_speeds();
void send(const std::vector<SpeedOrder>& orders);
void send(const std::vector<SteerOrder>& orders);

}  // namespace sumo_vehicle
}  // namespace pedzone
