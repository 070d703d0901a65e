// The direction kernel for one kind of vector. Included by one source file for each instruction
// set; everything is a template on the vector, so that no code built for a newer processor can be
// linked into what runs on an older one.
//
// Exactness: whatever order contacts are looked at in, each goes through the same arithmetic and
// the largest inverse time is free of order, so every short cut gives the brute-force choice to the
// bit as long as it only leaves out what cannot be the answer:
// (1) who cannot be touched before the horizon is not even listed (sight_impl.hpp);
// (2) fewer obstacles give a later first contact: with t from the near ones alone, g(t') for the
//     true t' ≤ t is at least g(min(t, D/2)), since g(t) = t² − t·D falls until D/2. A direction
//     whose bound lies above the best value found is out.
#pragma once

#include <cstddef>
#include <limits>

#include "model/direction_kernel.hpp"

namespace pedzone {

template <class Float>
struct KernelImpl {
  static constexpr std::size_t kLanes = Float::kLanes;

  /// Share of the largest g by which bounds are lowered: protects from rounding in (2), 1e-7.
  static constexpr float kBoundShare = 4e-6F;
  /// [s] protects from dividing by zero.
  static constexpr float kLeastTime = 1e-30F;
  /// Bound of a direction that has been tried or costs infinity.
  static constexpr float kTried = std::numeric_limits<float>::infinity();

  // ---- inverse times of contact ---------------------------------------------------------------

  /// A value of one obstacle in all lanes, or of kLanes obstacles.
  static Float one(const float* p) { return Float::all(*p); }
  static Float many(const float* p) { return Float::load(p); }

  /// Lanes are directions (get = one) or obstacles (get = many), from the i-th of the group on.
  template <Float (*get)(const float*)>
  static Float of_disc(const DiscGroup& g, std::size_t i, Float ex, Float ey) {
    const Float beta = get(g.px + i) * ex + get(g.py + i) * ey - get(g.q + i);
    const Float alpha = get(g.a + i) - (get(g.wx + i) * ex + get(g.wy + i) * ey);
    return beta + sqrt(beta * beta - alpha);
  }

  template <Float (*get)(const float*)>
  static Float of_face(const FaceGroup& g, std::size_t i, Float ex, Float ey) {
    const Float contact = get(g.nv + i) - (get(g.nx + i) * ex + get(g.ny + i) * ey);
    const Float along =
        get(g.x + i) * contact + (get(g.dx + i) * ex + get(g.dy + i) * ey - get(g.dv + i));
    return both(at_least(get(g.half_length + i) * contact, absolute(along)), contact);
  }

  /// The largest of u and those of some obstacles; lanes are directions.
  static Float of_discs(const DiscView& discs, Float ex, Float ey, Float u) {
    for (std::size_t j = 0; j < discs.size; ++j) {
      const DiscGroup& g = discs.groups[j / kObstacleGroup];
      u = larger(of_disc<one>(g, j % kObstacleGroup, ex, ey), u);
    }
    return u;
  }

  static Float of_faces(const FaceView& faces, Float ex, Float ey, Float u) {
    for (std::size_t j = 0; j < faces.size; ++j) {
      const FaceGroup& g = faces.groups[j / kObstacleGroup];
      u = larger(of_face<one>(g, j % kObstacleGroup, ex, ey), u);
    }
    return u;
  }

  /// The same with lanes for obstacles.
  static Float of_group(const DiscGroup& g, Float ex, Float ey, Float u) {
    for (std::size_t i = 0; i < kObstacleGroup; i += kLanes) {
      u = larger(of_disc<many>(g, i, ex, ey), u);
    }
    return u;
  }

  static Float of_group(const FaceGroup& g, Float ex, Float ey, Float u) {
    for (std::size_t i = 0; i < kObstacleGroup; i += kLanes) {
      u = larger(of_face<many>(g, i, ex, ey), u);
    }
    return u;
  }

  static std::size_t groups_of(std::size_t obstacles) {
    return (obstacles + kObstacleGroup - 1) / kObstacleGroup;
  }

  /// Inverse time in one direction with everything that the near ones left out, given what it is
  /// with those; anything from `enough` on where it is at least that.
  static float rest_of(const DirectionTask& task, float ex_k, float ey_k, float u_k,
                       float enough_k) {
    const Float ex = Float::all(ex_k), ey = Float::all(ey_k), enough = Float::all(enough_k);
    Float u = Float::all(u_k);
    const DiscGroup* group = task.far_discs.groups;
    const DiscGroup* const last = group + groups_of(task.far_discs.size);
    for (; group < last; group += 2) {
      u = of_group(group[1], ex, ey, of_group(group[0], ex, ey, u));
      if (bits(at_least(u, enough)) != 0) return largest(u);
    }
    Float still = Float::all(0.0F);
    for (std::size_t g = 0; g < groups_of(task.still_discs.size); ++g) {
      still = of_group(task.still_discs.groups[g], ex, ey, still);
    }
    for (std::size_t g = 0; g < groups_of(task.still_faces.size); ++g) {
      still = of_group(task.still_faces.groups[g], ex, ey, still);
    }
    return largest(larger(both(at_least(still, Float::all(1.0F / task.static_horizon)), still), u));
  }

  // ---- directions -----------------------------------------------------------------------------

  /// Walking velocities V·e of kLanes directions.
  struct Velocity {
    Float x, y;
  };
  static Velocity velocity(const DirectionTask& task, std::size_t k) {
    const Float hc = Float::all(task.heading_cos * task.speed);
    const Float hs = Float::all(task.heading_sin * task.speed);
    const Float oc = Float::load(task.candidates.cosine + k);
    const Float os = Float::load(task.candidates.sine + k);
    return {hc * oc - hs * os, hs * oc + hc * os};
  }

  /// D of Eq. 1 or Eq. 2.
  static Float weight(const DirectionTask& task, std::size_t k) {
    const CandidateView& c = task.candidates;
    const Float gc = Float::all(task.goal_cos * (2.0F * task.horizon));
    const Float gs = Float::all(task.goal_sin * (2.0F * task.horizon));
    if (task.half_angle) {
      return absolute(gc * Float::load(c.half_cosine + k) + gs * Float::load(c.half_sine + k));
    }
    return gc * Float::load(c.cosine + k) + gs * Float::load(c.sine + k);
  }

  /// One person's directions while it chooses.
  struct Directions {
    alignas(32) float ex[kMaxDirections], ey[kMaxDirections];
    alignas(32) float weight[kMaxDirections];
    alignas(32) float u[kMaxDirections];      ///< inverse time with the near ones
    alignas(32) float bound[kMaxDirections];  ///< of g from below, for the blocks looked at
  };

  static Float slack(const DirectionTask& task) {
    return Float::all(kBoundShare * task.horizon * task.horizon);
  }

  /// Lower bound of g = t² − t·D for all t ≤ `time`.
  static Float bound_of(const DirectionTask& task, std::size_t k, Float time, Float d) {
    const Float t = larger(smaller(time, Float::all(0.5F) * d), Float::all(0.0F));
    return t * (t - d) - slack(task) + Float::load(task.cost + k);
  }

  /// Inverse of the time below which g exceeds `value` for certain.
  static float enough_for(const DirectionTask& task, float value, float d) {
    const float half = 0.5F * d;
    const float square = half * half + (value + kBoundShare * task.horizon * task.horizon);
    const float t = half - __builtin_sqrtf(square > 0.0F ? square : 0.0F);
    return 1.0F / (t > kLeastTime ? t : kLeastTime);
  }

  /// Looks at the near ones in kLanes directions; returns the lowest of the bounds.
  static float look_near(const DirectionTask& task, std::size_t k, Directions& dirs) {
    const Velocity e = velocity(task, k);
    Float u = Float::all(1.0F / task.horizon);
    u = of_discs(task.near_discs, e.x, e.y, u);
    u = of_discs(task.vehicle_discs, e.x, e.y, u);
    u = of_faces(task.vehicle_faces, e.x, e.y, u);
    e.x.store(dirs.ex + k);
    e.y.store(dirs.ey + k);
    u.store(dirs.u + k);
    const Float bound = bound_of(task, k, Float::all(1.0F) / u, Float::load(dirs.weight + k));
    bound.store(dirs.bound + k);
    return smallest(bound);
  }

  static void try_direction(const DirectionTask& task, const Directions& dirs, std::size_t k,
                            float enough, DirectionChoice& best) {
    const float t = 1.0F / rest_of(task, dirs.ex[k], dirs.ey[k], dirs.u[k], enough);
    const float d = dirs.weight[k];
    const DirectionChoice choice{static_cast<std::uint32_t>(k), t, t * (t - d) + task.cost[k], d};
    if (best.index == kNoDirection || better(choice, best)) best = choice;
  }

  /// Whether a direction with that bound can still be the best.
  static bool hopeful(float bound, const DirectionChoice& best) {
    return best.index == kNoDirection ? bound < kTried : bound <= best.value;
  }

  /// The bounds of kLanes directions, that of one of them taken out.
  static Float settled(Float bound, std::size_t lane) {
    struct Window {
      float around[2 * kLanes - 1];
      constexpr Window() : around() {
        for (float& value : around) value = -kTried;
        around[kLanes - 1] = kTried;
      }
    };
    static constexpr Window kWindow;
    return larger(bound, Float::load(kWindow.around + kLanes - 1 - lane));
  }

  /// First of the lanes with the lowest value.
  static std::size_t first_lowest(Float values, float lowest) {
    return static_cast<std::size_t>(__builtin_ctz(bits(at_least(Float::all(lowest), values))));
  }

  /// Blocks of kLanes directions, each with the lowest bound in it. Bounds first know of nothing,
  /// then of the near ones.
  struct Blocks {
    static constexpr std::size_t kMost = (kMaxDirections / kLanes + kLanes - 1) / kLanes * kLanes;
    alignas(32) float lowest[kMost];

    Blocks() {
      for (std::size_t b = 0; b < kMost; b += kLanes) Float::all(kTried).store(lowest + b);
    }

    std::size_t best(std::size_t count) const {
      Float least = Float::load(lowest);
      for (std::size_t b = kLanes; b < count; b += kLanes) {
        least = smaller(Float::load(lowest + b), least);
      }
      const float value = smallest(least);
      std::size_t b = 0;
      while (bits(at_least(Float::all(value), Float::load(lowest + b))) == 0) b += kLanes;
      return b + first_lowest(Float::load(lowest + b), value);
    }
  };

  /// Tries the direction with the lowest bound of a block.
  static void try_best_of(const DirectionTask& task, Directions& dirs, std::size_t k,
                          float& lowest_bound, DirectionChoice& best) {
    const Float bound = Float::load(dirs.bound + k);
    const std::size_t lane = first_lowest(bound, lowest_bound);
    const Float left = settled(bound, lane);
    left.store(dirs.bound + k);
    lowest_bound = smallest(left);
    const float enough =
        best.index == kNoDirection
            ? kTried
            : enough_for(task, best.value - task.cost[k + lane], dirs.weight[k + lane]);
    try_direction(task, dirs, k + lane, enough, best);
  }

  static DirectionChoice choose(const DirectionTask& task, std::size_t first, std::size_t count,
                                DirectionChoice best) {
    Directions dirs;
    Blocks blocks;
    const std::size_t block_count = (count + kLanes - 1) / kLanes;
    for (std::size_t b = 0; b < block_count; ++b) {
      const std::size_t k = first + b * kLanes;
      const Float d = weight(task, k);
      d.store(dirs.weight + k);
      blocks.lowest[b] = smallest(bound_of(task, k, Float::all(task.horizon), d));
    }
    // A first good value from the most promising block lets others go without a look.
    const std::size_t start = blocks.best(block_count);
    if (!hopeful(blocks.lowest[start], best)) return best;
    blocks.lowest[start] = look_near(task, first + start * kLanes, dirs);
    if (hopeful(blocks.lowest[start], best)) {
      try_best_of(task, dirs, first + start * kLanes, blocks.lowest[start], best);
    }
    for (std::size_t b = 0; b < block_count; ++b) {
      if (b == start || !hopeful(blocks.lowest[b], best)) continue;
      blocks.lowest[b] = look_near(task, first + b * kLanes, dirs);
    }
    for (std::size_t b = blocks.best(block_count); hopeful(blocks.lowest[b], best);
         b = blocks.best(block_count)) {
      try_best_of(task, dirs, first + b * kLanes, blocks.lowest[b], best);
    }
    return best;
  }

  // ---- one obstacle, for the few who need it
  // ------------------------------------------------------

  static void times_of(const DirectionTask& task, const DiscView& discs, const FaceView& faces,
                       float* out) {
    for (std::size_t k = 0; k < task.candidates.padded; k += kLanes) {
      const Velocity e = velocity(task, k);
      Float u = of_discs(discs, e.x, e.y, Float::all(1.0F / task.horizon));
      u = of_faces(faces, e.x, e.y, u);
      (Float::all(1.0F) / u).store(out + k);
    }
  }
};

}  // namespace pedzone
