// Giving way to moving vehicles: direction and speed are chosen together, by a discomfort that
// grows before contact. Source: the formulation of vehicle.md, fitted to recordings by `pedzone
// calibrate`.
//
// Eq. 1 or 2 gets a further term. Chosen are the direction α and the share s of the speed with the
// least
//     d(α) + d_max²·[k·h(α, s) + w·(1 − s)²]
// where a vehicle is a discomfort within the margin
//     m = (m0 + m_v·|v|)·(1 + r·a)·exp(σ·z)
//
//   d, d_max     as in Eq. 1 and 2
//   s            1, 1.2, ½ or 0; 1.2 only as far as the person can walk so fast
//   h            the worst discomfort that any vehicle is within the next T. The vehicle keeps its
//                velocity v. The person stops where something that stands blocks its way: a wall
//                is no way out
//   k            weight of the discomfort; 0: there is no further term
//   w            what another speed costs: one w for hurrying (s > 1), one for slowing down
//   m0, m_v, r   parameters of the margin
//   a            max(0, cosine) of the angle between v and the person's heading: what comes from
//                behind cannot be watched
//   σ, z         by how much people differ, and each person's own standard normal number
//
// A slow vehicle's margin fades: a parked one is passed close.
//
// Every choice looks T ahead only. So a person would walk on before or beside a car of little more
// than its own speed V for as long as that drives. Instead it slows down until such a car is past,
// by the share
//     p·a·g·(1 − c/8 m)
//   p            a parameter (`lettingPass`)
//   g            from 0 where a·|v| is V to 1 at 1.5 V
//   c            distance of the car now
// On the recordings (CITR, back) people slow down from about 6 m on, to 0.87 of their speed beside
// it. Before one that comes towards them they slow down a little, too (CITR, front).
#pragma once

#include <span>
#include <vector>

#include "model/direction_kernel.hpp"
#include "model/surroundings.hpp"
#include "world/parameters.hpp"

namespace pedzone {

/// Share of the preferred speed. Assumed: the most that people hurry; 0.3 m/s of a usual speed.
inline constexpr float kMostHurry = 1.2F;

class GivingWay {
 public:
  /// Lists the vehicles that can be a discomfort, for a person whose margins are `caution` times
  /// the usual. Whether one may be in direction (ex, ey), where nothing is in the person's way for
  /// `free_time` [s]: a quick look that says yes too often, never no wrongly.
  bool notice(const Walker& walker, std::span<const VehicleView> vehicles,
              const Parameters& parameters, float caution, float ex, float ey, float free_time);

  /// Whether the choice that knows nothing of discomfort is free of it at full speed: then it is
  /// the best one. To be called after notice().
  bool comfortable(const DirectionTask& task, const DirectionChoice& known,
                   const Parameters& parameters, const DirectionKernel& kernel);

  /// Share of the speed that is left to who lets vehicles pass or meets them, [0, 1].
  static double pace_near(const Walker& walker, std::span<const VehicleView> vehicles,
                          const Parameters& parameters);

  /// Over the whole circle, after notice(). `hurry`: the greatest share of the speed, [1,
  /// kMostHurry]. `known`: the choice that knows nothing of discomfort; it may be that of
  /// another equation.
  PacedChoice choose(const Candidates& candidates, const DirectionTask& task,
                     const Parameters& parameters, const DirectionChoice& known, float hurry,
                     const DirectionKernel& kernel);

 private:
  void worst_of(const DirectionTask& task, float share, const Parameters& parameters,
                std::size_t first, std::size_t count, const DirectionKernel& kernel);
  /// The costs of one pace in a group of directions, `pace` [s²] by itself.
  void try_pace(const DirectionTask& task, float share, float pace, const Parameters& parameters,
                std::size_t first, const DirectionKernel& kernel);
  /// Costs of a group of directions, each at its best share of the speed; right up to `most` [s²].
  void price(const DirectionTask& task, const Parameters& parameters, std::size_t first, float most,
             const DirectionKernel& kernel);

  std::vector<VehicleFelt> vehicles_;
  float vx_ = 0.0F, vy_ = 0.0F;       ///< [m/s] of the person
  float hurry_ = 1.0F;                ///< the share of the speed in a hurry; 1: none
  float stop_[kMaxDirections];        ///< [s] until something that stands blocks the way
  float discomfort_[kMaxDirections];  ///< h
  float cost_[kMaxDirections];        ///< [s²] of the best speed share
  float share_[kMaxDirections];
};

}  // namespace pedzone
