#include "model/making_way.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pedzone {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

}  // namespace

void MakingWay::foresee(const Walker& walker, const VehicleView& view, const DirectionTask& task,
                        float speed, float lag) {
  for (std::size_t k = 0; k < task.candidates.padded; ++k) {
    const float c = task.candidates.cosine[k], s = task.candidates.sine[k];
    const float wish_x = (walker.heading_cos * c - walker.heading_sin * s) * speed;
    const float wish_y = (walker.heading_sin * c + walker.heading_cos * s) * speed;
    const float vx = std::lerp(wish_x, walker.vx, lag), vy = std::lerp(wish_y, walker.vy, lag);
    const float stop = stop_[k];
    float touch = time_to_touch(view, walker, {0.0F, 0.0F, vx, vy}, 0.0F);
    if (stop < touch) touch = time_to_touch(view, walker, {vx * stop, vy * stop}, stop);
    const float way_out = time_to_leave_its_way(view, vx, vy);
    const float leave = way_out > stop ? kNever : way_out;
    clear_[k] = std::min(clear_[k], touch);
    leave_[k] = std::max(leave_[k], leave);
    if (touch < kNever) lacking_[k] = std::max(lacking_[k], leave - touch);
  }
}

void MakingWay::exclude(const Candidates& candidates, bool stays) {
  const float* const excluded = candidates.excluded();
  float longest = 0.0F, least = kNever, soonest = kNever;
  for (std::size_t k = 0; k < candidates.padded(); ++k) {
    if (excluded[k] != 0.0F) continue;
    longest = std::max(longest, clear_[k]);
    least = std::min(least, lacking_[k]);
    soonest = std::min(soonest, leave_[k]);
  }
  for (std::size_t k = 0; k < candidates.padded(); ++k) {
    bool out = clear_[k] < longest;
    if (least < kNever) out = lacking_[k] > least;
    if (stays && soonest < kNever) out = leave_[k] > soonest;
    excluded_[k] = out ? kNever : excluded[k];
  }
}

PacedChoice MakingWay::choose(const Walker& walker, const Surroundings& surroundings,
                              const Candidates& candidates, DirectionTask task, const Haste& haste,
                              const DirectionKernel& kernel) {
  const std::size_t count = candidates.padded();
  kernel.times_of(task, surroundings.still_discs(), surroundings.still_faces(), 0, count, stop_);
  std::fill(clear_, clear_ + count, haste.soon);
  std::fill(lacking_, lacking_ + count, 0.0F);
  std::fill(leave_, leave_ + count, 0.0F);
  // Mean share, over that time, of the present velocity in a velocity that relaxes to another one.
  const float relaxed =
      haste.relaxation_time * (1.0F - std::exp(-haste.soon / haste.relaxation_time));
  const float lag = relaxed / haste.soon;
  for (const VehicleView& view : surroundings.vehicles()) {
    foresee(walker, view, task, haste.share * walker.speed, lag);
  }

  exclude(candidates, haste.stays);
  task.cost = excluded_;
  DirectionChoice best;
  best.index = kNoDirection;
  best = kernel.choose(task, 0, candidates.main_count(), best);
  return {kernel.choose(task, candidates.main_padded(), candidates.rest_count(), best),
          haste.share};
}

}  // namespace pedzone
