// Which vehicles another program drives although nobody has declared it (pedzone.external).
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "sumo/plan/told.hpp"
#include "sumo/plan/vehicle.hpp"

namespace pedzone {

/// What another program was found to move.
struct OutsideRecord {
  double time = 0.0;  ///< [s] when it was found
  std::string id;
};

/// SUMO tells how fast a vehicle drives and how fast it would drive if no client had told it
/// anything. The two are the same to the bit, but for who is told a speed (setSpeed, slowDown) or
/// moved (moveToXY): measured with 1.15. Beside emergency vehicles they differ for some who brake,
/// too: these count as SUMO's.
class OutsideDrivers {
 public:
  /// `told`: by pedzone; must outlive it.
  explicit OutsideDrivers(const Told& told) : told_(told) {}

  /// Marks as external those of `seen`, after a step of `dt` [s], whom somebody else drives, until
  /// they have driven as SUMO lets them for two seconds. `steered`: by pedzone itself.
  void mark(std::vector<VehicleSeen>& seen, const std::unordered_set<std::string>& steered,
            double time, double dt);

  /// That id stands for another vehicle from now on, or for none.
  void forget(const std::string& vehicle) { suspects_.erase(vehicle); }

  /// Whether another program drives any of those seen so far, declared or found.
  bool any() const { return any_; }
  /// Whoever was found, each once, in time.
  const std::vector<OutsideRecord>& found() const { return found_; }

 private:
  struct Suspect {
    int odd_steps = 0;         ///< in a row in which it did not drive as SUMO lets it
    double as_sumo = 0.0;      ///< [s] in a row in which it did
    double last_speed = -1.0;  ///< [m/s] a step before; < 0: not known
    bool driven = false, told_of = false;
  };
  bool is_odd(const VehicleSeen& vehicle, const Suspect& suspect, double dt) const;

  const Told& told_;
  std::unordered_map<std::string, Suspect> suspects_;
  std::vector<OutsideRecord> found_;
  bool any_ = false;
};

}  // namespace pedzone
