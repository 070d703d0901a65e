// Whom vehicles pushed and ran into in a run, by name.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "crowd/push_log.hpp"
#include "sumo/live/takeover.hpp"

namespace pedzone {

/// A vehicle has run into somebody.
struct RunIntoRecord {
  double time = 0.0;  ///< [s] by which SUMO's outputs name the step
  std::string person, vehicle, zone;
  double speed = 0.0;            ///< [m/s] of the vehicle
  Vec2 position = Vec2::Zero();  ///< [m] of the person
  bool just_inserted = false;  ///< SUMO had put the vehicle there at most 3 s before: it departed,
                               ///< or its teleport ended
};

class PushRecords {
 public:
  PushRecords(const std::vector<Zone>& zones, const std::vector<std::unique_ptr<Crowd>>& crowds,
              const Takeover& takeover, const Fleet& fleet)
      : zones_(zones), crowds_(crowds), takeover_(takeover), fleet_(fleet) {}

  /// After the crowds have walked for `dt` [s] from `time` [s] on, and before anybody is handed
  /// over. Returns the ids of the vehicles that overlap somebody whom they ran into.
  std::vector<std::string> take(double time, double dt);

  const PushLog& log() const { return log_; }
  /// Of all steps so far, in time.
  const std::vector<RunIntoRecord>& run_into() const { return run_into_; }

 private:
  std::string person(std::uint64_t key) const;
  const FleetVehicle* vehicle(std::uint64_t key) const;  ///< null: it is not near a zone any more

  const std::vector<Zone>& zones_;
  const std::vector<std::unique_ptr<Crowd>>& crowds_;
  const Takeover& takeover_;
  const Fleet& fleet_;
  PushLog log_;
  std::vector<RunIntoRecord> run_into_;
};

}  // namespace pedzone
