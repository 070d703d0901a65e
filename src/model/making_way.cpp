#include "model/making_way.hpp"

#include <algorithm>
#include <limits>

namespace pedzone {

void MakingWay::shorten(const Walker& walker, const VehicleView& view, const DirectionTask& task,
                        const DirectionKernel& kernel) {
  discs_.clear();
  faces_.clear();
  add_vehicle(view, walker, discs_, faces_);
  kernel.times_of(task, discs_.view(), faces_.view(), touch_);
  for (std::size_t k = 0; k < task.candidates.padded; ++k) {
    float touch = touch_[k];
    if (stop_[k] < touch) {
      const float c = task.candidates.cosine[k], s = task.candidates.sine[k];
      const float way = walker.speed * stop_[k];
      const float dx = (walker.heading_cos * c - walker.heading_sin * s) * way;
      const float dy = (walker.heading_sin * c + walker.heading_cos * s) * way;
      touch = time_to_standing(view, walker, dx, dy, stop_[k]);
    }
    clear_[k] = std::min(clear_[k], touch);
  }
}

DirectionChoice MakingWay::choose(const Walker& walker, const Surroundings& surroundings,
                                  const Candidates& candidates, DirectionTask task, float soon,
                                  const DirectionKernel& kernel) {
  const std::size_t count = candidates.padded();
  kernel.times_of(task, surroundings.still_discs(), surroundings.still_faces(), stop_);
  std::fill(clear_, clear_ + count, soon);
  for (const VehicleView& view : surroundings.vehicles()) shorten(walker, view, task, kernel);

  float longest = 0.0F;
  for (std::size_t k = 0; k < count; ++k) {
    if (candidates.excluded()[k] == 0.0F) longest = std::max(longest, clear_[k]);
  }
  constexpr float kOut = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < count; ++k) {
    excluded_[k] = clear_[k] < longest ? kOut : candidates.excluded()[k];
  }
  task.excluded = excluded_;
  DirectionChoice best;
  best.index = kNoDirection;
  best = kernel.choose(task, 0, candidates.main_count(), best);
  return kernel.choose(task, candidates.main_padded(), candidates.rest_count(), best);
}

}  // namespace pedzone
