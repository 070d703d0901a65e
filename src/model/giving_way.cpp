#include "model/giving_way.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone {
namespace {

constexpr float kShares[] = {1.0F, 0.75F, 0.5F, 0.25F, 0.0F};
constexpr float kFullMarginSpeed = 0.5F;  // [m/s] slower vehicles have smaller margins (vehicle.md)

/// Whether the vehicle can come within `margin` of a person that walks anywhere, within `time`:
/// somebody who is always farther away than that from the circle round it feels no discomfort.
bool may_annoy(const VehicleView& view, const Walker& walker, float margin, float time) {
  const VehicleShape& s = *view.shape;
  const float vx = s.vx * s.cos + s.vy * s.sin, vy = s.vy * s.cos - s.vx * s.sin;
  const float speed2 = s.speed * s.speed;
  const float t =
      speed2 > 0.0F ? std::clamp((view.x * vx + view.y * vy) / speed2, 0.0F, time) : 0.0F;
  const float x = view.x - vx * t, y = view.y - vy * t;
  const float reach = s.reach + margin + walker.speed * time;
  return x * x + y * y < reach * reach;
}

}  // namespace

bool GivingWay::notice(const Walker& walker, std::span<const VehicleView> vehicles,
                       const Parameters& parameters, float caution) {
  vehicles_.clear();
  vx_ = walker.vx;
  vy_ = walker.vy;
  const auto time = static_cast<float>(parameters.discomfort_horizon);
  for (const VehicleView& view : vehicles) {
    const VehicleShape& s = *view.shape;
    const float usual = static_cast<float>(parameters.discomfort_margin) +
                        static_cast<float>(parameters.discomfort_margin_time) * s.speed;
    const float margin = usual * caution * std::min(1.0F, s.speed / kFullMarginSpeed);
    if (margin <= 0.0F || !may_annoy(view, walker, margin, time)) continue;
    vehicles_.push_back(
        {view.x, view.y, s.cos, s.sin, s.vx, s.vy, s.half_length, s.half_width, margin});
  }
  return !vehicles_.empty();
}

void GivingWay::worst_of(const DirectionTask& task, float share, const Parameters& parameters,
                         std::size_t first, std::size_t count, const DirectionKernel& kernel) {
  const Stroll stroll{share,
                      static_cast<float>(parameters.discomfort_horizon),
                      static_cast<float>(parameters.relaxation_time),
                      vx_,
                      vy_,
                      stop_};
  std::fill(discomfort_ + first, discomfort_ + first + count, 0.0F);
  for (const Annoyance& vehicle : vehicles_) {
    kernel.discomfort(task, vehicle, stroll, first, count, discomfort_);
  }
}

bool GivingWay::comfortable(const DirectionTask& task, std::uint32_t direction,
                            const Parameters& parameters, const DirectionKernel& kernel) {
  kernel.times_of(task, task.still_discs, task.still_faces, stop_);
  const std::size_t first = direction / kDirectionGroup * kDirectionGroup;
  worst_of(task, 1.0F, parameters, first, kDirectionGroup, kernel);
  return discomfort_[direction] == 0.0F;
}

GivingWay::Choice GivingWay::choose(const Candidates& candidates, DirectionTask task,
                                    const Parameters& parameters, DirectionChoice known,
                                    const DirectionKernel& kernel) {
  const std::size_t count = candidates.padded();
  const float unit = task.horizon * task.horizon;  // d_max² over V²
  const float discomfort = unit * static_cast<float>(parameters.discomfort);
  const float slowing = unit * static_cast<float>(parameters.slowing_cost);
  for (const float share : kShares) {
    worst_of(task, share, parameters, 0, count, kernel);
    const float slow = slowing * (1.0F - share) * (1.0F - share);
    for (std::size_t k = 0; k < count; ++k) {
      const float cost = candidates.excluded()[k] + discomfort * discomfort_[k] + slow;
      const bool better = share == kShares[0] || cost < cost_[k];
      cost_[k] = better ? cost : cost_[k];
      share_[k] = better ? share : share_[k];
    }
  }
  task.cost = cost_;
  known.value += cost_[known.index];
  known = kernel.choose(task, 0, candidates.main_count(), known);
  known = kernel.choose(task, candidates.main_padded(), candidates.rest_count(), known);
  return {known, share_[known.index]};
}

}  // namespace pedzone
