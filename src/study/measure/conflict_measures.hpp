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

/// The moment by which a conflict is told, as its type is: of the contact, else of the least TTC,
/// else of the PET, else of the least clearance.
Extreme moment_of(const Conflict& conflict);

class ConflictMeasures {
 public:
  void add(const Conflict& conflict);
  /// Appends the measures conflict.*; those of which no conflict has a value are left out.
  void finish(std::map<std::string, double>& values) const;

 private:
  std::map<EncounterType, double> types_;
  double count_ = 0.0, serious_ = 0.0, contacts_ = 0.0;
  std::vector<double> ttc_, pet_, drac_, clearance_;
};

}  // namespace pedzone::study
