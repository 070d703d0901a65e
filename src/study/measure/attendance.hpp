// Whether SUMO has written everybody who was under way: its devices can leave some out.
#pragma once

#include <span>
#include <string>
#include <unordered_set>

#include "conflict/tracker.hpp"
#include "core/text_hash.hpp"
#include "study/measure/tripinfo_reader.hpp"

namespace pedzone::study {

/// Notes who is in fcd-output, step by step.
class Attendance {
 public:
  void step(std::span<const PersonSample> persons, std::span<const VehicleSample> vehicles);

  /// Throws InputError where fcd-output lacks somebody who was under way for two steps of `dt` [s]
  /// or more by `end` [s], or tripinfo-output a vehicle: measures would be of some of them only.
  /// `scenario`: its configuration, named in the error. `trips`: not settled yet.
  void check(const Trips& trips, double dt, double end, const std::string& scenario) const;

 private:
  using Ids = std::unordered_set<std::string, TextHash, std::equal_to<>>;

  Ids persons_, vehicles_;
};

}  // namespace pedzone::study
