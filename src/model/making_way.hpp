// Getting out of the way of a vehicle that would run into the person if it stood still.
#pragma once

#include "model/direction_kernel.hpp"
#include "model/surroundings.hpp"

namespace pedzone {

/// [s] assumed: a person whom a vehicle would reach so soon minds nothing but to get out of its
/// way: the last-moment guard of those who give way by discomfort, and of a child and its adult.
inline constexpr double kLastMoment = 1.0;

/// How somebody gets out of the way.
struct Haste {
  float soon = 1.0F;             ///< [s] so much time there is
  float share = 1.0F;            ///< of the preferred speed that it walks at
  float relaxation_time = 0.5F;  ///< [s] of its velocity
  bool stays = false;            ///< it goes nowhere: it takes the shortest way out
};

/// Eq. 1 and 2 price standing at 0 and any way back at more, but for this person standing is no way
/// out. So only some directions count:
/// - those in which the person gets beside the way of every vehicle it is aware of, before the
///   vehicle touches it;
/// - where there is none, those that lack least time for that: the vehicle may brake;
/// - where there is no room beside the way, those that keep clear of vehicles longest.
/// Among these Eq. 1 or 2 decide, over the whole circle. The person is taken to walk with a mean of
/// its velocity and of what that relaxes to. It stops where something that stands blocks it.
class MakingWay {
 public:
  PacedChoice choose(const Walker& walker, const Surroundings& surroundings,
                     const Candidates& candidates, DirectionTask task, const Haste& haste,
                     const DirectionKernel& kernel);

 private:
  /// `lag`: share of the present velocity in that mean.
  void foresee(const Walker& walker, const VehicleView& view, const DirectionTask& task,
               float speed, float lag);

  /// The directions that do not count.
  void exclude(const Candidates& candidates, bool stays);

  float stop_[kMaxDirections];     ///< [s] until something that stands blocks the way
  float clear_[kMaxDirections];    ///< [s] without touching a vehicle, at most `soon`
  float leave_[kMaxDirections];    ///< [s] until it is beside all vehicles' ways
  float lacking_[kMaxDirections];  ///< [s] by which it is touched too early to get out of the way
  float excluded_[kMaxDirections];
};

}  // namespace pedzone
