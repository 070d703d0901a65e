// pedzone attached to a SUMO simulation: what the command line runs and what a program embeds.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sumo/calls/own_sumo.hpp"
#include "sumo/calls/session.hpp"
#include "sumo/live/observation.hpp"
#include "sumo/live/run_totals.hpp"
#include "zone/vehicle_path.hpp"

namespace pedzone {

struct SimulationOptions {
  Scenario scenario;
  std::vector<ZoneSpec> zones;             ///< empty: the zone is found by itself
  bool needs_zone = true;                  ///< else a network without shared space is SUMO's alone
  Profiles profiles;                       ///< that persons may name
  std::vector<PanelSpec> panels;           ///< people to be made beside the scenario's own
  std::vector<PathSpec> paths;             ///< that persons may name
  std::vector<VehiclePath> vehicle_paths;  ///< at most one of a vehicle
  std::optional<std::uint64_t> seed;       ///< of SUMO and of pedzone; unset: SUMO's
  std::optional<double> end;               ///< [s] overrides the scenario's
  std::optional<TraciAddress> attach;      ///< a SUMO that runs
  std::string screenshots;                 ///< folder for a picture of each step; empty: none
  std::optional<OwnSumo> own;              ///< one to start; neither: in this process
  bool alone = false;                      ///< no other program moves anybody: none is looked for
};

/// A person on foot whom SUMO walks, or who waits as SUMO says.
struct Passer {
  std::string id;
  Vec2 position = Vec2::Zero();  ///< [m]
  double heading = 0.0;          ///< [rad]
};

/// Runs SUMO in this process and walks its persons through the zones. Between two steps the
/// embedding program may call libsumo itself: add, remove and reroute persons and vehicles.
/// One at a time in a process, since libsumo's state is global.
class Simulation {
 public:
  /// Reads the network, builds the zones, starts SUMO.
  /// Throws InputError or SumoError.
  explicit Simulation(const SimulationOptions& options);
  ~Simulation();

  /// One SUMO step. Throws SumoError, ConnectionLost: what was simulated can still be told.
  void step();
  /// From now on shows every step of SUMO's, as soon as its outcome is read: the last one with
  /// close(). One observer; it must not call the simulation.
  void observe(std::function<void(const Observation&)> observer);
  /// Whether SUMO's end time is reached, or, without one, nobody is left.
  bool finished() const;
  /// Ends SUMO so that its outputs are complete. One that was joined goes on, with its people
  /// back; nothing where it is gone. Throws SumoError.
  void close();
  /// Ids of those who could not be given back with close(): SUMO has them stand.
  const std::vector<std::string>& stranded() const;

  double time() const;         ///< [s]
  double step_length() const;  ///< [s]
  double end_time() const;     ///< [s]; negative: none
  const std::vector<Zone>& zones() const;
  const Network& network() const;
  const std::vector<WaypointPath>& paths() const;
  /// Persons that pedzone walks now, in the order they were taken over.
  const std::vector<Guest>& guests() const;
  PersonView view(const Guest& guest) const;
  /// Everybody else on foot, as SUMO has them; slow.
  std::vector<Passer> passers() const;
  /// [m] Where people can be: in the zones; of `everything`: on all lanes of persons, too.
  Region ground(bool everything) const;
  /// Who has begun to squeeze through a jam of people so far, in time.
  const std::vector<JamRecord>& jams() const;
  /// Who has stepped out to cross a street between the junctions so far, in time.
  const std::vector<StreetCrossed>& crossings() const;
  /// Whom vehicles have run into so far, in time.
  const std::vector<RunIntoRecord>& run_into() const;
  /// Vehicles and persons that another program was found to move, in time.
  const std::vector<OutsideRecord>& outside_vehicles() const;
  const std::vector<OutsideRecord>& outside_persons() const;
  /// Whether SUMO has other clients, and no vehicle near a zone was declared or found to be driven
  /// by one of them so far. Not to be asked after close().
  bool misses_drivers() const;
  /// What the guests are about to do, in their order; slow.
  std::vector<Insight> insights();
  /// Who has not moved for long, looked for every few seconds.
  const Standstills& stuck_persons() const;
  /// Whether SUMO prints each of its warnings. Not to be asked after close().
  bool warns() const;
  /// Whether SUMO is to write a person-summary-output. Each place that pedzone tells it counts
  /// there as one more who walks (SUMO 1.15 and 1.18). Not to be asked after close().
  bool miscounts_walking() const;
  /// Figures so far.
  RunSummary summary() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pedzone
