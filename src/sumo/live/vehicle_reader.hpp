// Reads the vehicles near the zones after each step.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "sumo/calls/vehicles.hpp"
#include "sumo/plan/fleet.hpp"
#include "sumo/plan/lane_forks.hpp"
#include "sumo/plan/told.hpp"

namespace pedzone {

class VehicleReader {
 public:
  /// Both must outlive it.
  VehicleReader(const Network& network, SumoVehicles& sumo)
      : network_(network), sumo_(sumo), forks_(network) {}

  /// Those that belong to the fleet, at `time` [s], in SUMO's order, and those far away that
  /// pedzone has told a speed (they were moved there): they are to be given back. Where the weather
  /// leaves them less grip, one that is new is told to brake less, whatever it brakes for. Their
  /// routes are valid until the next call.
  std::vector<VehicleSeen> read(const Fleet& fleet, const Told& told, double time);

  /// That id stands for another vehicle from now on, or for none.
  void forget(const std::string& vehicle) { known_.erase(vehicle); }

 private:
  /// What is not asked in every step.
  struct Known {
    std::string type;  ///< SUMO's id; empty: not asked yet
    VehicleTraits traits;
    double ask_at = 0.0;     ///< [s] when it is asked again what it has been declared to be
    bool taxi = false;       ///< SUMO sends it here and there, without a new id for its route
    std::string route_id;    ///< SUMO's; it gives an id out again when a vehicle gets its next one
    std::vector<int> route;  ///< indices into Network::edges
    int lane = -1;           ///< index into Network::lanes, when it was asked by which it goes on
    std::vector<int> means;  ///< those, where it can take several
  };
  void ask_type(const std::string& id, double grip, bool again, Known& known) const;
  /// The rear of a long one is near zones when its front no longer is.
  bool is_near(const Fleet& fleet, const std::string& id, const Vec2& front) const;
  void ask(const std::string& id, double time, Known& known) const;
  void ask_route(const std::string& id, Known& known) const;
  void ask_lanes(const VehicleSeen& vehicle, bool again, Known& known) const;

  const Network& network_;
  SumoVehicles& sumo_;
  LaneForks forks_;
  std::unordered_map<std::string, Known> known_;  ///< by vehicle
};

}  // namespace pedzone
