// Looks now and then for persons and vehicles that do not get on, anywhere in SUMO.
#pragma once

#include <memory>
#include <vector>

#include "sumo/calls/session.hpp"
#include "sumo/live/takeover.hpp"
#include "sumo/plan/standstills.hpp"

namespace pedzone {

/// Not counted: who waits by a stage of SUMO's, rides or waits for a ride; whom an activity makes
/// stand or sit; vehicles at a stop of their own.
class StuckWatch {
 public:
  /// All must outlive it.
  StuckWatch(const std::vector<Zone>& zones, const std::vector<std::unique_ptr<Crowd>>& crowds,
             const Takeover& takeover, Session& sumo)
      : zones_(zones), crowds_(crowds), takeover_(takeover), sumo_(sumo) {}

  /// To be called in each step, at `time` [s]; looks every few seconds.
  void update(double time);
  /// Looks now.
  void look(double time);

  const Standstills& persons() const { return persons_; }
  const Standstills& vehicles() const { return vehicles_; }

 private:
  bool rests(const std::string& person) const;
  std::string place_of_person(const std::string& id) const;

  const std::vector<Zone>& zones_;
  const std::vector<std::unique_ptr<Crowd>>& crowds_;
  const Takeover& takeover_;
  Session& sumo_;
  Standstills persons_, vehicles_;
  std::vector<Standstills::Present> present_;  ///< kept for its memory
  double look_at_ = 0.0;                       ///< [s]
  double looked_at_ = -1.0;                    ///< [s]
};

}  // namespace pedzone
