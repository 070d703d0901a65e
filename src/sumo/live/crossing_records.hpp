// Who crossed streets between the junctions in a run, by name.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "conflict/gap_acceptance.hpp"
#include "results/crossing_table.hpp"
#include "sumo/live/takeover.hpp"

namespace pedzone {

/// What a run's crossings add up to.
struct CrossingTotals {
  long crossings = 0;                 ///< times that somebody stepped out
  long without_looking = 0;           ///< of those
  double mean_wait_s = 0.0;           ///< at the kerb, of all of them
  std::optional<GapAcceptance> gaps;  ///< unset: too few
};

CrossingTotals totals_of(const std::vector<StreetCrossed>& crossings);

class CrossingRecords {
 public:
  CrossingRecords(const std::vector<Zone>& zones, const std::vector<std::unique_ptr<Crowd>>& crowds,
                  const Takeover& takeover)
      : zones_(zones), crowds_(crowds), takeover_(takeover) {}

  /// After the crowds have walked from `time` [s] on, and before anybody is handed over.
  void take(double time);

  /// Of all steps so far, in time.
  const std::vector<StreetCrossed>& all() const { return all_; }

 private:
  const std::vector<Zone>& zones_;
  const std::vector<std::unique_ptr<Crowd>>& crowds_;
  const Takeover& takeover_;
  std::vector<StreetCrossed> all_;
};

}  // namespace pedzone
