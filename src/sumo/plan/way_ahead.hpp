// The way that a vehicle will take: its route's next lanes as a line.
#pragma once

#include <vector>

#include "sumo/plan/vehicle.hpp"
#include "zone/zone.hpp"

namespace pedzone {

class WayAhead {
 public:
  /// The network must outlive it.
  WayAhead(const Network& network, const std::vector<Zone>& zones);

  /// Sets a vehicle's way, `distance` [m] beyond its front or to its route's end, the first junction
  /// on it, and its zone: the first on that way, else the first of all. One that is on no lane goes straight on.
  void look(FleetVehicle& vehicle, double distance) const;

 private:
  int junction_after(std::span<const int> route, int index) const;
  int next_lane(int lane, std::span<const int> route, int& index) const;

  const Network& network_;
  std::vector<int> zone_of_lane_;                   ///< -1: in no zone
  std::vector<std::vector<int>> connections_from_;  ///< per lane: indices of Network::connections
};

}  // namespace pedzone
