// Measures of a run's conflicts.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "conflict/conflict.hpp"

namespace pedzone::study {

/// [s] serious where the TTC falls below (Hydén 1987 and later practice) ...
inline constexpr double kSeriousTtc = 1.5;
/// [s] ... or the PET does (as Laureshyn et al. 2010 and others take it).
inline constexpr double kSeriousPet = 1.0;

/// [m/s] slower, a vehicle is taken to stand: who touches it has walked into it. Assumed.
inline constexpr double kMovingVehicle = 0.5;

/// The moment by which a conflict is told, as its type is: of the contact, else of the least TTC,
/// else of the PET, else of the least clearance.
Extreme moment_of(const Conflict& conflict);

/// Whether the vehicle moves at that moment.
bool with_moving_vehicle(const Conflict& conflict);

/// Whether it begins with a contact: SUMO put one of the two onto the other, departing or
/// teleported, and nobody ran into anybody.
bool is_insertion(const Conflict& conflict);

/// Conflicts with moving vehicles, those with standing ones, and insertions are counted apart.
class ConflictMeasures {
 public:
  void add(const Conflict& conflict);
  /// Appends the measures conflict.*; those of which no conflict has a value are left out.
  void finish(std::map<std::string, double>& values) const;

 private:
  struct Counts {
    double all = 0.0, serious = 0.0, contacts = 0.0;
    void add(const Conflict& conflict);
  };

  std::map<EncounterType, double> types_;
  Counts moving_, standing_;
  double insertions_ = 0.0;
  std::vector<double> ttc_, pet_, drac_, clearance_;
};

}  // namespace pedzone::study
