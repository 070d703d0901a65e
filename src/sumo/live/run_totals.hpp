// What a run adds up to: the figures of the summary.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <unordered_set>

#include "sumo/calls/session.hpp"
#include "sumo/files/sumo_messages.hpp"
#include "sumo/live/crossing_records.hpp"
#include "sumo/live/push_records.hpp"
#include "sumo/live/takeover.hpp"
#include "sumo/plan/standstills.hpp"
#include "sumo/plan/yielding.hpp"

namespace pedzone {

/// Those who have not moved for Standstills::kLong.
struct Stuck {
  std::vector<Standstill> now;  ///< the longest first
  std::size_t most = 0;         ///< at any time
  double most_at_s = 0.0;       ///< [s] when that was first
};

/// The summary of a run, as printed and as written by `--summary`.
struct RunSummary {
  struct {
    long seen = 0, controlled = 0, arrived = 0, walking = 0, lost = 0;
    long given_back = 0;              ///< persons, at least once
    long takeovers = 0, returns = 0;  ///< of all of them
    double mean_speed = 0.0;          ///< [m/s] inside the zone
    double mean_delay_s = 0.0;        ///< [s] per person, over its free walk of the same distance
    double mean_waiting_s = 0.0;      ///< [s] per person
  } persons;
  struct {
    long seen = 0, yielding = 0, contacts = 0;
    double min_clearance_m = std::numeric_limits<double>::infinity();
    double mean_delay_s = 0.0;    ///< [s] SUMO's timeLoss gathered near the zones
    long insertion_contacts = 0;  ///< of the contacts: of a vehicle that SUMO put onto somebody
    long standing_contacts = 0;   ///< of the others: only while it stood, or crept at 0.5 m/s
  } vehicles;
  std::vector<LateBraking> late_brakings;  ///< in time
  Stuck stuck_persons, stuck_vehicles;     ///< anywhere in SUMO
  struct {
    long teleports = 0, collisions = 0, emergency_stops = 0;
    std::optional<WarningCounts>
        warnings;  ///< unset: nobody listened, or SUMO is told to be silent
  } sumo;          ///< as it counts
  struct {
    long persons = 0;                           ///< whom a vehicle that drives pushed
    double longest_m = 0.0, fastest_mps = 0.0;  ///< of all their pushes
  } pushes;
  std::vector<JamRecord> jams;              ///< in time
  std::vector<RunIntoRecord> run_into;      ///< in time
  std::optional<CrossingTotals> crossings;  ///< unset: no zone has a street to cross anywhere
  int interrupted_by = 0;                   ///< the signal that ended the run early; 0: none
  bool sumo_gone = false;                   ///< SUMO, which was joined, ended the run early
  struct {
    double simulated_s = 0.0, wall_s = 0.0, sumo_s = 0.0, pedzone_s = 0.0;
    double us_per_person_step = 0.0;
    long person_steps = 0;
  } time;
};

/// Watches persons and vehicles step by step.
class RunTotals {
 public:
  /// How many departed and arrived in SUMO's last step.
  void count_persons(long departed, long arrived);
  /// What SUMO counted in its last step.
  void count_events(const SumoEvents& events);
  /// That id stands for another vehicle from now on, or for none.
  void forget(const std::string& vehicle) { known_vehicles_.erase(vehicle); }
  /// Distances between guests and vehicles now; delays of vehicles.
  void observe(const Fleet& fleet, const Takeover& takeover);

  /// Figures so far. `walking`: persons in SUMO now.
  RunSummary summary(const Takeover& takeover, const PushRecords& pushes, const Yielding& yielding,
                     std::size_t walking) const;

 private:
  enum class Contact { kInsertion, kStanding, kDriving };
  long teleports_ = 0, collisions_ = 0, emergency_stops_ = 0;
  std::vector<SumoEvents::Collision> colliding_;  ///< in the last step
  long departed_ = 0, arrived_ = 0, person_steps_ = 0;
  double min_clearance_ = std::numeric_limits<double>::infinity();
  std::map<std::pair<std::string, std::string>, Contact> contacts_;  ///< of person and vehicle
  std::unordered_set<std::string> known_vehicles_;
  long vehicles_ = 0;   ///< that have been near a zone: several may have one id, one by one
  double delay_ = 0.0;  ///< [s] of all of them
};

}  // namespace pedzone
