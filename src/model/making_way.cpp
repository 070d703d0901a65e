#include "model/making_way.hpp"

#include <algorithm>
#include <limits>

namespace pedzone {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

}  // namespace

void MakingWay::foresee(const Walker& walker, const VehicleView& view, const DirectionTask& task,
                        const DirectionKernel& kernel) {
  discs_.clear();
  faces_.clear();
  add_vehicle(view, walker, discs_, faces_);
  kernel.times_of(task, discs_.view(), faces_.view(), touch_);
  for (std::size_t k = 0; k < task.candidates.padded; ++k) {
    const float c = task.candidates.cosine[k], s = task.candidates.sine[k];
    const float vx = (walker.heading_cos * c - walker.heading_sin * s) * walker.speed;
    const float vy = (walker.heading_sin * c + walker.heading_cos * s) * walker.speed;
    const float stop = stop_[k];
    const float touch =
        stop < touch_[k] ? time_to_standing(view, walker, vx * stop, vy * stop, stop) : touch_[k];
    const float leave = time_to_leave_its_way(view, vx, vy);
    clear_[k] = std::min(clear_[k], touch);
    lacking_[k] = std::max(lacking_[k], leave > stop ? kNever : leave - touch);
  }
}

DirectionChoice MakingWay::choose(const Walker& walker, const Surroundings& surroundings,
                                  const Candidates& candidates, DirectionTask task, float soon,
                                  const DirectionKernel& kernel) {
  const std::size_t count = candidates.padded();
  kernel.times_of(task, surroundings.still_discs(), surroundings.still_faces(), stop_);
  std::fill(clear_, clear_ + count, soon);
  std::fill(lacking_, lacking_ + count, 0.0F);
  for (const VehicleView& view : surroundings.vehicles()) foresee(walker, view, task, kernel);

  float longest = 0.0F, least = kNever;
  for (std::size_t k = 0; k < count; ++k) {
    if (candidates.excluded()[k] != 0.0F) continue;
    longest = std::max(longest, clear_[k]);
    least = std::min(least, lacking_[k]);
  }
  const bool beside = longest < soon && least < kNever;
  for (std::size_t k = 0; k < count; ++k) {
    const bool out = beside ? lacking_[k] > least : clear_[k] < longest;
    excluded_[k] = out ? kNever : candidates.excluded()[k];
  }
  task.cost = excluded_;
  DirectionChoice best;
  best.index = kNoDirection;
  best = kernel.choose(task, 0, candidates.main_count(), best);
  return kernel.choose(task, candidates.main_padded(), candidates.rest_count(), best);
}

}  // namespace pedzone
