// Room for vehicles that SUMO is about to put on the road. SUMO looks for other vehicles there, but
// not for people whom pedzone walks. So these keep away from the place, as from a garage's exit.
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

  /// Adds claims to what the crowds see at `time` [s]: one for each vehicle that departs within
  /// 4 s, or should have in the last 4 s, and is not in the fleet. A claim reaches from where the
  /// vehicle's rear will be to where its front will be. Its way is valid within the step only.
  void add_claims(double time, const Fleet& fleet, std::vector<VehicleState>& out);

 private:
  void add_claim(const Departure& departure, int lane, std::vector<VehicleState>& out);

  const Network& network_;
  std::vector<Departure> departures_;
  std::size_t next_ = 0;  ///< the first that is not long over
  std::vector<Polyline> ways_;
};

}  // namespace pedzone
