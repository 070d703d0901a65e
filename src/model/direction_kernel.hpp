// Chooses one person's direction: the inner loop of everything.
#pragma once

#include <cstdint>

#include "model/candidates.hpp"
#include "model/obstacle_lists.hpp"

namespace pedzone {

/// One person's choice, ready to be computed.
struct DirectionTask {
  const Candidates* candidates = nullptr;
  float heading_cos = 1.0F, heading_sin = 0.0F;
  /// cos and sin of α0 − heading (Eq. 1) or of half of it (Eq. 2).
  float goal_cos = 1.0F, goal_sin = 0.0F;
  bool half_angle = true;                  ///< Eq. 2
  float speed = 1.34F;                     ///< [m/s] V, preferred
  float horizon = 7.5F;                    ///< [s] d_max/V
  float static_horizon = 7.5F;             ///< [s] contacts with what stands still count up to here
  const DiscList* moving_discs = nullptr;  ///< persons, corners of moving vehicles
  const FaceList* moving_faces = nullptr;  ///< sides of moving vehicles
  const DiscList* static_discs = nullptr;  ///< ends of walls, corners of parked vehicles
  const FaceList* static_faces = nullptr;  ///< walls, sides of parked vehicles
};

/// A candidate and its value. Of two candidates the smaller value wins; then the one nearer to
/// the goal; then the lower index, which is the right-hand one of a mirrored pair.
struct DirectionChoice {
  std::uint32_t index = 0;  ///< in Candidates
  float time = 0.0F;        ///< [s] until the first contact, at most the horizon
  float value = 0.0F;  ///< [s²] t² − t·D, D = 2·horizon·cos((α0 − α)/x): Eq. 1 or 2 over V²
  float weight = 0.0F;  ///< [s] D

  bool better_than(const DirectionChoice& other) const {
    if (value != other.value) return value < other.value;
    if (weight != other.weight) return weight > other.weight;
    return index < other.index;
  }
};

/// Time [s] of the first contact, at most `horizon`, for every direction, Candidates::padded() of
/// them.
struct DirectionTimes {
  float all[kMaxDirections];     ///< with anything
  float still[kMaxDirections];   ///< with what stands still
  float weight[kMaxDirections];  ///< D of DirectionChoice
};

/// The best of the main directions, or of the rest of the circle; or all there is to know.
struct DirectionKernel {
  DirectionChoice (*best_main)(const DirectionTask& task);
  DirectionChoice (*best_rest)(const DirectionTask& task);
  void (*times)(const DirectionTask& task, DirectionTimes& out);
  /// `out[k]`: time [s] until the first contact with these alone, at most the task's horizon.
  void (*times_of)(const DirectionTask& task, const DiscList& discs, const FaceList& faces,
                   float* out);
  const char* name;
};

const DirectionKernel& baseline_kernel();
/// nullptr where this processor (or this build) has no AVX2.
const DirectionKernel* avx2_kernel();
/// The fastest one that this processor can run.
const DirectionKernel& fastest_kernel();

}  // namespace pedzone
