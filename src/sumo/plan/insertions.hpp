// Room for vehicles that SUMO is about to put on the road. SUMO looks for other vehicles there, but
// not for people whom pedzone walks. So these keep away from the place, as from a garage's exit.
#pragma once

#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

#include "sumo/files/departures.hpp"
#include "sumo/plan/fleet.hpp"

namespace pedzone {

class Insertions {
 public:
  /// `departures` by time. The network must outlive it.
  Insertions(const Network& network, std::vector<Departure> departures);

  /// Adds claims to what the crowds see at `time` [s], after a step of `dt` [s]. A claim reaches
  /// from where the vehicle's rear will be to where its front will be. Its way is valid within the
  /// step only. Claimed is the place of each vehicle that departs within 4 s, and of the first on
  /// each edge of those that SUMO could not insert yet (`pending`, in its order), unless a vehicle
  /// stands there: of each half a minute of such a wait for 20 s, so that people can get past.
  void add_claims(double time, double dt, const std::vector<std::string>& pending,
                  const Fleet& fleet, std::vector<VehicleState>& out);

 private:
  std::vector<const Departure*> expected(double time,
                                         const std::vector<std::string>& pending) const;
  std::vector<const Departure*> planned(const std::string& vehicle) const;
  void add_claim(const Departure& departure, int lane, const Fleet& fleet,
                 std::vector<VehicleState>& out);

  const Network& network_;
  std::vector<Departure> departures_;
  std::unordered_map<std::string, std::vector<std::size_t>> index_;  ///< of departures_, by vehicle
  std::size_t next_ = 0;       ///< the first that SUMO has not tried yet
  std::deque<Polyline> ways_;  ///< spans into them are given away: they stay where they are
};

}  // namespace pedzone
