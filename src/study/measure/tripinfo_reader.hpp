// SUMO's tripinfo-output: who was to travel, when, and what became of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pedzone::study {

/// A <walk> of a person's plan that was begun.
struct WalkStage {
  double depart = 0.0;            ///< [s]
  std::optional<double> arrival;  ///< [s]; unset: still under way at the end
  double max_speed = 0.0;         ///< [m/s] > 0 of the person, as SUMO has it
};

struct PersonTrip {
  std::string id, type;
  double due = 0.0;               ///< [s] intended departure
  std::optional<double> arrival;  ///< [s] of the plan's last walk or ride; unset: not by the end
  std::vector<WalkStage> walks;   ///< in turn
  bool moves = false;             ///< has a walk or ride in its plan
};

struct VehicleTrip {
  std::string id, type;
  double due = 0.0;               ///< [s] intended departure
  std::optional<double> arrival;  ///< [s]; unset: never, or SUMO removed it
  bool departed = true;
  double depart_delay = 0.0;  ///< [s] from `due` to the departure, or to the end of the run
  double time_loss = 0.0;     ///< [s]
};

struct Trips {
  std::vector<PersonTrip> persons;    ///< by id
  std::vector<VehicleTrip> vehicles;  ///< by id
};

/// Reads tripinfo-output of SUMO 1.15 with --tripinfo-output.write-unfinished and
/// .write-undeparted. `due` of vehicles that never departed is left open: see settle().
/// Throws InputError where the file is missing, cut off or something else.
Trips read_tripinfo(const std::string& file);

/// Completes trips once the end of the run [s] is known: SUMO says of a vehicle that never departed
/// only how long it had been waiting by then. Leaves out who was due at the end or later: which of
/// them SUMO has loaded says nothing.
void settle(Trips& trips, double end);

}  // namespace pedzone::study
