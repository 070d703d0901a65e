// When and where the vehicles of a scenario are to begin: read from its files before SUMO starts,
// since SUMO tells it of nobody before it has put them on the road.
#pragma once

#include <string>
#include <vector>

#include "sumo/files/scenario.hpp"

namespace pedzone {

/// A vehicle, trip or regular flow's vehicle that begins at a known place.
struct Departure {
  std::string vehicle;        ///< id
  double time = 0.0;          ///< [s] when it is due
  int edge = -1;              ///< index into Network::edges
  int lane = -1;              ///< index into Network::lanes; -1: SUMO chooses one
  double position = 0.0;      ///< [m] ≥ 0 of its front from the lane's begin
  double length = 5.0;        ///< [m]; of a distribution that of its longest member
  double width = 1.8;         ///< [m] likewise
  RoadClasses its_class = 0;  ///< 0: not known, or one of several
};

/// Those on one of `edges` (indices into Network::edges), by time. Left out: flows with a
/// probability, and positions that SUMO chooses (departPos random, free, last, stop). What SUMO
/// will refuse is left to SUMO.
std::vector<Departure> read_departures(const Scenario& scenario, const Network& network,
                                       const std::vector<int>& edges);

}  // namespace pedzone
