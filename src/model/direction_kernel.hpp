// Chooses one person's direction: the inner loop of everything. Plain data in and out, so that the
// code behind it can be built for several instruction sets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "model/candidates.hpp"
#include "model/obstacle_lists.hpp"
#include "model/shoulders.hpp"

namespace pedzone {

/// The persons of a grid, by slot; kSlotGroup more may be read behind the last.
struct PersonSlots {
  const std::int32_t *x, *y;    ///< lattice
  const float *vx, *vy;         ///< [m/s]
  const float* speed2;          ///< [m²/s²] vx² + vy²
  const float* radius;          ///< [m]
  const float* turned_radius;   ///< [m]
  const float* present_radius;  ///< [m]
  const float *hx, *hy;         ///< unit vector of the heading
  float broadest;               ///< [m] largest of the radii
};

/// Slots are looked at in groups of this many.
inline constexpr std::uint32_t kSlotGroup = 8;

/// Slots [first, first + 8); bit i of `used` says whether slot first + i is meant.
struct SlotGroup {
  std::uint32_t first, used;
};

/// What one person sees of others.
struct Sight {
  std::int32_t x, y;  ///< lattice, the person
  float heading_cos, heading_sin;
  float field_cos;      ///< of the half field of view
  float reach;          ///< [m] d_max
  float soon;           ///< [s] who can be touched within this is told apart
  float radius;         ///< [m] of the person's body
  float turned_radius;  ///< [m]
  Shoulders shoulders;  ///< as it holds them in what it looks for
  float speed;          ///< [m/s] V, preferred
  float horizon;        ///< [s]
  float static_reach;   ///< [m] who stands farther away than this does not count
};

/// Far persons are tried in so many at a time, between two questions whether to go on.
inline constexpr std::size_t kFarGroup = 2 * kObstacleGroup;

/// Room for persons who are seen: as many as there are slots to look at, and two groups more.
struct SeenSpace {
  float *x, *y, *vx, *vy;  ///< while they are picked out: places seen from the person, velocities
  float *radius, *turned;  ///< [m]
  float *hx, *hy;          ///< headings, read where shoulders depend on them
  DiscGroup* discs;        ///< what comes of them, filled up to two groups
};

/// How many discs there are in either space.
struct Seen {
  std::size_t near, far;
  std::size_t groups;  ///< with any of them
};

/// One person's choice, ready to be computed. All of it is avoided; what stands in the "near"
/// lists is looked at first, the rest only for directions that may still be the best.
struct DirectionTask {
  CandidateView candidates;
  /// [s²] ≥ 0, added to a candidate's value: 0 in Eq. 1 and 2; discomfort over V² (giving_way.hpp);
  /// infinity for what is no candidate (the padding, too).
  const float* cost = nullptr;
  float heading_cos = 1.0F, heading_sin = 0.0F;
  /// cos and sin of α0 − heading (Eq. 1) or of half of it (Eq. 2).
  float goal_cos = 1.0F, goal_sin = 0.0F;
  bool half_angle = true;       ///< Eq. 2
  float speed = 1.34F;          ///< [m/s] V, preferred
  float horizon = 7.5F;         ///< [s] d_max/V
  float static_horizon = 7.5F;  ///< [s] contacts with what stands still count up to here
  DiscView near_discs{};        ///< persons near by
  DiscView far_discs{};         ///< other persons, filled up to two groups
  DiscView vehicle_discs{};     ///< corners of moving vehicles
  FaceView vehicle_faces{};     ///< sides of moving vehicles
  DiscView still_discs{};       ///< ends of walls, corners of parked vehicles
  FaceView still_faces{};       ///< walls, sides of parked vehicles
};

/// A candidate and its value.
struct DirectionChoice {
  std::uint32_t index = 0;  ///< in Candidates
  float time = 0.0F;        ///< [s] until the first contact, at most the horizon
  float value = 0.0F;  ///< [s²] t² − t·D + cost, D = 2·horizon·cos((α0 − α)/x): Eq. 1 or 2 over V²
  float weight = 0.0F;  ///< [s] D
};

/// A direction and the speed in it.
struct PacedChoice {
  DirectionChoice direction;
  double share = 1.0;  ///< of the preferred speed, [0, 1]; above 1: in a hurry
};

/// Of two candidates the smaller value wins; then the one nearer to the goal; then the lower index,
/// which is the right-hand one of a mirrored pair. (Always inlined: no instruction set may own it.)
[[gnu::always_inline]] constexpr bool better(const DirectionChoice& a, const DirectionChoice& b) {
  if (a.value != b.value) return a.value < b.value;
  if (a.weight != b.weight) return a.weight > b.weight;
  return a.index < b.index;
}

inline constexpr std::uint32_t kNoDirection = ~0U;

/// A vehicle that comes near enough to be a discomfort, as one person meets it.
struct VehicleFelt {
  float x, y;                     ///< [m] the person in the vehicle's frame, x ahead, y left
  float cos, sin;                 ///< of the vehicle's heading
  float vx, vy;                   ///< [m/s] of the vehicle
  float half_length, half_width;  ///< [m]
  float margin;                   ///< [m] > 0 clearance from which on it is none
  float reach;                    ///< [m] from its centre, farther away it is none
};

/// How a person might go on in each direction: with that share of its preferred speed, once its
/// present velocity v has relaxed (which carries it by (v − wanted)·glide), until something stops
/// it.
struct PacedWalk {
  float share = 1.0F;           ///< of the preferred speed, >= 0
  float time = 4.0F;            ///< [s] how far ahead it looks
  float glide = 0.5F;           ///< [s] relaxation time
  float vx = 0.0F, vy = 0.0F;   ///< [m/s] present velocity
  const float* stop = nullptr;  ///< [s] at the preferred speed, until something that stands stops
                                ///< it, by direction; it stays there
};

/// What directions cost beside their values where that is dear to know: asked for by group, and
/// only where the best direction may be.
struct DirectionPrices {
  const float* cost;  ///< [s²] ≥ 0 by direction
  /// Fills in the costs of directions [first, first + kDirectionGroup), which need to be right up
  /// to `most` [s²] only.
  void (*ask)(void* asker, std::size_t first, float most);
  void* asker;
};

/// The operations behind which vector code stands.
struct DirectionKernel {
  const char* name;
  /// Those of the groups whom the person sees and could touch within its horizon, near and far.
  /// `met`, room for as many groups, or null: groups that hold all of these.
  Seen (*see)(const PersonSlots& slots, std::span<const SlotGroup> groups, const Sight& sight,
              const SeenSpace& near, const SeenSpace& far, SlotGroup* met);
  /// The best of the directions [first, first + count) and of `best`, which may be none
  /// (index kNoDirection); `first` is a multiple of kDirectionGroup. None where all are excluded.
  DirectionChoice (*choose)(const DirectionTask& task, std::size_t first, std::size_t count,
                            DirectionChoice best);
  /// The best of all directions, padding included, when each costs what `prices` says instead of
  /// the task's own cost. `known`: one whose time is known and whose price has been asked for; its
  /// value may be that of another goal.
  DirectionChoice (*choose_priced)(const DirectionTask& task, const DirectionPrices& prices,
                                   DirectionChoice known);
  /// `out[k]` for directions [first, first + count), multiples of kDirectionGroup: time [s] until
  /// the first contact with these alone, at most the horizon.
  void (*times_of)(const DirectionTask& task, const DiscView& discs, const FaceView& faces,
                   std::size_t first, std::size_t count, float* out);
  /// Raises `out[k]` for directions [first, first + count) to the discomfort h that the vehicle is
  /// at its worst within the walk's time; first and count are multiples of kDirectionGroup. With
  /// c the least clearance of the person's centre and m the margin: (1 − c/m)² for c < m,
  /// 1 − c/(2m) inside the rectangle (c < 0: depth).
  void (*discomfort)(const DirectionTask& task, const VehicleFelt& vehicle, const PacedWalk& walk,
                     std::size_t first, std::size_t count, float* out);
};

/// For every x86-64 processor.
const DirectionKernel& baseline_kernel();
/// To be used only where has_avx2().
const DirectionKernel& avx2_kernel();
bool has_avx2();
/// The fastest one that this processor can run.
const DirectionKernel& fastest_kernel();

}  // namespace pedzone
