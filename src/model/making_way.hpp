// Getting out of the way of a vehicle that would run into the person if it stood still.
#pragma once

#include "model/direction_kernel.hpp"
#include "model/surroundings.hpp"

namespace pedzone {

/// Standing is no way out for that person, though Eq. 1 and 2 price it at 0 and any way back at
/// more. So only those directions count that keep the person clear of every vehicle it is aware of
/// for `soon` [s], it being taken to stop where something that stands blocks it. Where there is
/// none, those count that lack least time to get beside the vehicle's way, since it may brake; and
/// where there is no room beside it, those that keep clear longest. Among them Eq. 1 or 2 decide,
/// over the whole circle.
class MakingWay {
 public:
  DirectionChoice choose(const Walker& walker, const Surroundings& surroundings,
                         const Candidates& candidates, DirectionTask task, float soon,
                         const DirectionKernel& kernel);

 private:
  void foresee(const Walker& walker, const VehicleView& view, const DirectionTask& task,
               const DirectionKernel& kernel);

  float stop_[kMaxDirections];     ///< [s] until something that stands blocks the way
  float clear_[kMaxDirections];    ///< [s] without touching a vehicle, at most `soon`
  float touch_[kMaxDirections];    ///< [s] until a vehicle is touched by a person that walks on
  float lacking_[kMaxDirections];  ///< [s] by which it is touched too early to get out of the way
  float excluded_[kMaxDirections];
  DiscList discs_;
  FaceList faces_;
};

}  // namespace pedzone
