// A car on the street of four edges, for tests of the fleet and of vehicles' ways.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "four_edges.hpp"

namespace pedzone::test {

class FleetTest : public ::testing::Test, protected FourEdges {
 protected:
  /// A car on a lane of e1, at x [m], on its way e0 – e3.
  VehicleSeen car(double x, double speed) const {
    VehicleSeen vehicle = seen_vehicle("car", {x, 0.0}, speed);
    vehicle.lane = lane_of(e1);
    vehicle.route = route_;
    vehicle.route_index = 1;
    return vehicle;
  }

  /// The only vehicle, after a step of `dt` [s] in which it was first at `before`.
  FleetVehicle moved(const VehicleSeen& before, const VehicleSeen& now, double dt) const {
    const std::vector<Zone> all = zones();
    Fleet fleet(network, all);
    fleet.update({before}, dt);
    fleet.update({now}, dt);
    return fleet.vehicles().at(0);
  }

  FleetVehicle one(const VehicleSeen& seen) const {
    Fleet fleet(network, zones());
    fleet.update({seen}, 0.1);
    return fleet.vehicles().at(0);
  }

  VehicleState state(const FleetVehicle& vehicle, double dt) const {
    Fleet fleet(network, zones());
    fleet.vehicles() = {vehicle};
    std::vector<VehicleState> states;
    fleet.states(dt, states);
    return states.at(0);
  }

  std::vector<int> route_{e0, e1, e2, e3};
};

}  // namespace pedzone::test
