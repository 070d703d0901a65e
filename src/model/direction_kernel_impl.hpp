// The direction kernel for one kind of vector. Included by one source file for each instruction
// set; everything is a template on the vector, so that no code built for a newer processor can be
// linked into what runs on an older one.
#pragma once

#include <cstddef>

#include "model/direction_kernel.hpp"

namespace pedzone {

template <class Float>
struct KernelImpl {
  static Float inverse_time_discs(const DiscList& discs, Float ex, Float ey, Float u) {
    for (std::size_t j = 0; j < discs.size; ++j) {
      const Float beta =
          Float::all(discs.px[j]) * ex + Float::all(discs.py[j]) * ey - Float::all(discs.q[j]);
      const Float alpha =
          Float::all(discs.a[j]) - (Float::all(discs.wx[j]) * ex + Float::all(discs.wy[j]) * ey);
      u = larger(beta + sqrt(beta * beta - alpha), u);
    }
    return u;
  }

  static Float inverse_time_faces(const FaceList& faces, Float ex, Float ey, Float u) {
    const Float zero = Float::all(0.0F);
    for (std::size_t j = 0; j < faces.size; ++j) {
      const Float contact =
          Float::all(faces.nv[j]) - (Float::all(faces.nx[j]) * ex + Float::all(faces.ny[j]) * ey);
      const Float along =
          Float::all(faces.x[j]) * contact +
          (Float::all(faces.dx[j]) * ex + Float::all(faces.dy[j]) * ey - Float::all(faces.dv[j]));
      const Float met =
          both(at_least(along, zero), at_least(Float::all(faces.length[j]) * contact, along));
      u = larger(both(met, contact), u);
    }
    return u;
  }

  /// Walking velocities V·e of kLanes directions.
  struct Velocity {
    Float x, y;
  };
  static Velocity velocity(const DirectionTask& task, std::size_t k) {
    const Float hc = Float::all(task.heading_cos * task.speed);
    const Float hs = Float::all(task.heading_sin * task.speed);
    const Float oc = Float::load(task.candidates->cosine() + k);
    const Float os = Float::load(task.candidates->sine() + k);
    return {hc * oc - hs * os, hs * oc + hc * os};
  }

  /// D of Eq. 1 or Eq. 2.
  static Float weight(const DirectionTask& task, std::size_t k) {
    const Candidates& c = *task.candidates;
    const Float gc = Float::all(task.goal_cos * (2.0F * task.horizon));
    const Float gs = Float::all(task.goal_sin * (2.0F * task.horizon));
    if (task.half_angle) {
      return absolute(gc * Float::load(c.half_cosine() + k) + gs * Float::load(c.half_sine() + k));
    }
    return gc * Float::load(c.cosine() + k) + gs * Float::load(c.sine() + k);
  }

  /// Inverse time to what stands still; 0 beyond the static horizon.
  static Float inverse_time_still(const DirectionTask& task, Velocity e) {
    Float u = inverse_time_discs(*task.static_discs, e.x, e.y, Float::all(0.0F));
    u = inverse_time_faces(*task.static_faces, e.x, e.y, u);
    return both(at_least(u, Float::all(1.0F / task.static_horizon)), u);
  }

  static void times_at(const DirectionTask& task, std::size_t k, float* all, float* still) {
    const Velocity e = velocity(task, k);
    Float u = Float::all(1.0F / task.horizon);
    const Float u_still = larger(inverse_time_still(task, e), u);
    u = inverse_time_discs(*task.moving_discs, e.x, e.y, u_still);
    u = inverse_time_faces(*task.moving_faces, e.x, e.y, u);
    (Float::all(1.0F) / u).store(all);
    (Float::all(1.0F) / u_still).store(still);
  }

  static DirectionChoice best(const DirectionTask& task, std::size_t first, std::size_t count) {
    DirectionChoice best;
    for (std::size_t k = first; k < first + count; k += Float::kLanes) {
      float time[Float::kLanes], still[Float::kLanes], d[Float::kLanes];
      times_at(task, k, time, still);
      weight(task, k).store(d);
      for (std::size_t i = 0; i < Float::kLanes && k + i < first + count; ++i) {
        const DirectionChoice choice{static_cast<std::uint32_t>(k + i), time[i],
                                     time[i] * (time[i] - d[i]), d[i]};
        if (k + i == first || choice.better_than(best)) best = choice;
      }
    }
    return best;
  }

  static DirectionChoice best_main(const DirectionTask& task) {
    return best(task, 0, task.candidates->main_count());
  }
  static DirectionChoice best_rest(const DirectionTask& task) {
    return best(task, task.candidates->main_padded(), task.candidates->rest_count());
  }

  static void times(const DirectionTask& task, DirectionTimes& out) {
    for (std::size_t k = 0; k < task.candidates->padded(); k += Float::kLanes) {
      times_at(task, k, out.all + k, out.still + k);
      weight(task, k).store(out.weight + k);
    }
  }

  static void times_of(const DirectionTask& task, const DiscList& discs, const FaceList& faces,
                       float* out) {
    for (std::size_t k = 0; k < task.candidates->padded(); k += Float::kLanes) {
      const Velocity e = velocity(task, k);
      Float u = Float::all(1.0F / task.horizon);
      u = inverse_time_discs(discs, e.x, e.y, u);
      u = inverse_time_faces(faces, e.x, e.y, u);
      (Float::all(1.0F) / u).store(out + k);
    }
  }
};

}  // namespace pedzone
