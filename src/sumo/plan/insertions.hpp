// Room for vehicles that SUMO is about to put on the road. It looks for other vehicles there, and not
// for people whom pedzone walks: they keep from the place as people keep from a garage's exit.
#pragma once

#include <vector>

#include "sumo/files/departures.hpp"
#include "sumo/plan/fleet.hpp"

namespace pedzone {

class Insertions {
 public:
  /// `departures` by time. The network must outlive it.
  Insertions(const Network& network, std::vector<Departure> departures)
      : network_(network), departures_(std::move(departures)) {}

  /// Adds to what the crowds see, at `time` [s], the claims of those that are due within 4 s, or
  /// were no longer ago than that, and are not in the fleet: from where their rear will be to where
  /// their front will. The ways of these are read within the step only.
  void add_claims(double time, const Fleet& fleet, std::vector<VehicleState>& out);

 private:
  void add_claim(const Departure& departure, int lane, std::vector<VehicleState>& out);

  const Network& network_;
  std::vector<Departure> departures_;
  std::size_t next_ = 0;  ///< the first that is not long over
  std::vector<Polyline> ways_;
};

}  // namespace pedzone
