// Which encounters of a person and a vehicle to show: the most dangerous ones, and not always the
// same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "conflict/conflict.hpp"

namespace pedzone::study {

/// How dangerous an encounter was: less is more dangerous, by kind and then value. The order:
/// 1. contacts, but for those where the bodies only brush each other: the greatest closing speed
///    first;
/// 2. by TTC, those that close in at more than 1 m/s: the least first;
/// 3. by TTC, the slower ones: the least first;
/// 4. those that were never on a collision course, by PET: the least first;
/// 5. all others by clearance: the least first.
/// Encounters with a moving vehicle come before all with a standing one, which have the same order.
/// Insertions (conflict_measures.hpp) are last.
struct Danger {
  int kind = 0;
  double value = 0.0;
};
Danger danger_of(const Conflict& conflict);

/// Takes any number of encounters, keeping a few bytes of each.
class EncounterChoice {
 public:
  /// Where an encounter is to be found again.
  struct Place {
    std::size_t run = 0;  ///< as the user counts them
    std::size_t row = 0;  ///< of its table of conflicts
  };

  /// `scenario`: places and ids are compared within one only.
  void add(std::size_t scenario, const Place& place, const Conflict& conflict);
  std::size_t count() const { return candidates_.size(); }

  /// At most `most` of them, the most dangerous first. None of a person or vehicle of one before
  /// it (in whatever run: other seeds have the same ids), nor within `apart` [m] of one.
  std::vector<Place> most_dangerous(std::size_t most, double apart) const;

 private:
  struct Candidate {
    std::uint32_t scenario, person, vehicle, run, row;
    int kind;
    float value, x, y;
  };
  bool alike(const Candidate& a, const Candidate& b, double apart) const;
  std::uint32_t number_of(const std::string& id);

  std::unordered_map<std::string, std::uint32_t> ids_;
  std::vector<Candidate> candidates_;
};

}  // namespace pedzone::study
