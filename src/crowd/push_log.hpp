// What vehicles did to people in many steps: pushes joined, and who was run into.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "crowd/state/person.hpp"

namespace pedzone {

/// What vehicles did to one person so far.
struct PushedPerson {
  double way = 0.0;       ///< [m] by which they moved it in the longest of its pushes
  double speed = 0.0;     ///< [m/s] of the fastest of them
  bool run_into = false;  ///< a vehicle has run into it
};

/// A vehicle has run into a person.
struct RunInto {
  double time = 0.0;                      ///< [s] begin of the step in which it did
  std::uint64_t person = 0, vehicle = 0;  ///< their keys
  double speed = 0.0;                     ///< [m/s] of the vehicle
  Vec2 position = Vec2::Zero();           ///< [m] of the person
};

/// Takes the pushes of a crowd, or of several that have no person in common, step by step. Whom a
/// vehicle has moved along before its bumper by more than a step, it has run into.
class PushLog {
 public:
  /// Those of the step of `dt` [s] that begins at `time` [s]. A push goes on, by whichever vehicle,
  /// until there has been none for 1 s; so does a vehicle's running into a person.
  void add(double time, double dt, std::span<const VehiclePush> pushes);

  /// Everybody who was moved by 1 cm or more in one push, or run into; by key.
  const std::map<std::uint64_t, PushedPerson>& persons() const { return persons_; }
  /// In time; of one step by person and vehicle.
  const std::vector<RunInto>& run_into() const { return run_into_; }

 private:
  struct Going {
    double way = 0.0;                                        ///< [m] so far
    double last = -std::numeric_limits<double>::infinity();  ///< [s] end of its last step
  };

  struct Pair {
    Going carried;                                           ///< as VehiclePush
    double last = -std::numeric_limits<double>::infinity();  ///< [s] end of its last running into
  };

  std::map<std::uint64_t, PushedPerson> persons_;
  std::map<std::uint64_t, Going> going_;  ///< of each person
  std::map<std::pair<std::uint64_t, std::uint64_t>, Pair> pairs_;
  std::vector<RunInto> run_into_;
};

}  // namespace pedzone
