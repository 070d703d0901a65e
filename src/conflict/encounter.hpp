// What is remembered of a pair from step to step: the extremes of its measures.
#pragma once

#include <functional>

#include "conflict/conflict.hpp"
#include "conflict/passing.hpp"

namespace pedzone {

/// A pair in one step, measured.
struct Meeting {
  double time = 0.0;                                                     ///< [s] of the step
  double before = 0.0;                                                   ///< [s] of the step before
  Vec2 person = Vec2::Zero();                                            ///< [m] its centre
  Vec2 person_velocity = Vec2::Zero(), vehicle_velocity = Vec2::Zero();  ///< [m/s]
  Vec2 centre = Vec2::Zero(), axis = Vec2::UnitX();  ///< [m] of the vehicle; unit vector
  Approach approach;
  EncounterType type = EncounterType::kHeadOn;
  std::optional<bool> by_pedzone;      ///< pedzone walks the person; nothing: not known
  bool braking = false;                ///< the vehicle slowed down since the step before
  std::optional<double> ttc;           ///< [s] within horizon and range
  Closest closest{0.0, std::nullopt};  ///< since the step before
  std::optional<Passing> passing;      ///< a place both were at, new in this step
};

/// The type by the directions [rad] of both (the person's: where it moves or, standing, faces).
EncounterType type_of(const Approach& approach, double person_direction, double vehicle_direction,
                      bool vehicle_stands);

struct Encounter {
  Conflict conflict;

  /// Takes a step in which the pair mattered. `aware` is asked only where needed.
  void record(const Meeting& meeting, const std::function<std::optional<bool>()>& aware);
  /// Takes a step in which it did not: only how near they came.
  void record_clearance(const Meeting& meeting);

 private:
  /// By this meeting the conflict is told, as far as is known.
  void tell_by(const Meeting& meeting);
  void record_contact_course(const Meeting& meeting);
  void record_closeness(const Meeting& meeting);

  std::optional<Reaction> last_ttc_;  ///< of the last step that had one
  std::optional<bool> noticed_;       ///< the person has been aware of the vehicle
  bool started_ = false;
};

}  // namespace pedzone
