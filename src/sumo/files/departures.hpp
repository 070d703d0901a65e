// When and where the vehicles of a scenario are to begin: read from its files before SUMO starts,
// since SUMO tells it of nobody before it has put them on the road.
#pragma once

#include <optional>
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
  double position = 0.0;      ///< [m] ≥ 0 of its front from the lane's begin, as SUMO counts
  double length = 5.0;        ///< [m]; of a distribution that of its longest member
  double width = 1.8;         ///< [m] likewise
  RoadClasses its_class = 0;  ///< 0: not known, or one of several
  /// [m] of its middle to the left of the lane's, as far as there is room; nothing: SUMO chooses.
  std::optional<double> lateral = 0.0;
};

/// Those on one of `edges` (indices into Network::edges), by time, in a simulation from
/// `begin` to `end` [s] (below 0: open). A vehicle whose route is one of a distribution is there
/// once for each edge that it may begin on. Left out: flows with a probability, and places that
/// SUMO chooses (departPos random, free, last, stop; departEdge random). What SUMO will refuse is
/// left to SUMO.
std::vector<Departure> read_departures(const Scenario& scenario, const Network& network,
                                       const std::vector<int>& edges, double begin, double end);

}  // namespace pedzone
