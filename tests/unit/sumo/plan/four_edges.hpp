// A street from west to east for the tests of plans: e0 – e1 – e2 – e3, each 50 m long, with one
// lane 4 m wide. e1 and e2 are the zone.
#pragma once

#include <string>
#include <vector>

#include "sumo/plan/fleet.hpp"
#include "zone/zone.hpp"

namespace pedzone::test {

struct FourEdges {
  FourEdges();

  /// Adds an edge from x = `begin` to x = `end` [m], with lanes side by side.
  int add_edge(const std::string& id, const std::string& from, const std::string& to, double begin,
               double end, int lanes = 1);
  /// People pass from one to the other within the zone.
  void link(int a, int b);
  /// Vehicles pass from a lane to another.
  void connect(int from_lane, int to_lane);
  /// People pass over a walking area between the two.
  void put_walking_area_between(int before, int after);
  /// What of the zone is walkable.
  void has_space(const Ring& outline);
  /// People pass over it between e2 and e3, which begins 2 m later, and the zone has it, too.
  /// Returns an edge that they come to after e3.
  int add_walking_area();
  int lane_of(int edge) const { return network.edges[edge].lanes[0]; }
  std::vector<Zone> zones() const { return {zone}; }

  Network network;
  Zone zone;
  int e0 = 0, e1 = 0, e2 = 0, e3 = 0;
};

/// A vehicle as SUMO tells of it: 4 m long, 2 m wide, its front at `front` [m], on its way east.
VehicleSeen seen_vehicle(const std::string& id, const Vec2& front, double speed);

}  // namespace pedzone::test
