#include "model/giving_way.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pedzone {
namespace {

constexpr float kShares[] = {1.0F, 0.75F, 0.5F, 0.25F, 0.0F};
constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr float kSlack = 1e-5F;           // numerical: share of d_max² that rounding may take
constexpr float kFullMarginSpeed = 0.5F;  // [m/s] slower vehicles have smaller margins (vehicle.md)

/// Whether something at (x, y) [m] from a vehicle's centre that moves by (vx, vy) [m/s] relative to
/// it can come within `reach` of that centre in `time`.
bool comes_near(float x, float y, float vx, float vy, float reach, float time) {
  const float v2 = vx * vx + vy * vy;
  const float t = v2 > 0.0F ? std::clamp(-(x * vx + y * vy) / v2, 0.0F, time) : 0.0F;
  const float near_x = x + vx * t, near_y = y + vy * t;
  return near_x * near_x + near_y * near_y < reach * reach;
}

}  // namespace

bool GivingWay::notice(const Walker& walker, std::span<const VehicleView> vehicles,
                       const Parameters& parameters, float caution, float ex, float ey,
                       float free_time) {
  vehicles_.clear();
  const auto glide = static_cast<float>(parameters.relaxation_time);
  const float walk_x = walker.speed * ex, walk_y = walker.speed * ey;
  const float lag_x = glide * (walker.vx - walk_x), lag_y = glide * (walker.vy - walk_y);
  bool near = false;
  vx_ = walker.vx;
  vy_ = walker.vy;
  const auto time = static_cast<float>(parameters.discomfort_horizon);
  for (const VehicleView& view : vehicles) {
    const VehicleShape& s = *view.shape;
    const float usual = static_cast<float>(parameters.discomfort_margin) +
                        static_cast<float>(parameters.discomfort_margin_time) * s.speed;
    const float margin = usual * caution * std::min(1.0F, s.speed / kFullMarginSpeed);
    if (margin <= 0.0F) continue;
    // The person from the vehicle's centre, in the world's frame.
    const float x = view.x * s.cos - view.y * s.sin, y = view.x * s.sin + view.y * s.cos;
    const float reach = s.reach + margin;
    const float anywhere = reach + walker.speed * (time + glide) + glide * walker.pace();
    if (!comes_near(x, y, -s.vx, -s.vy, anywhere, time)) continue;
    near = near || free_time < time ||
           comes_near(x + lag_x, y + lag_y, walk_x - s.vx, walk_y - s.vy, reach, time);
    vehicles_.push_back(
        {view.x, view.y, s.cos, s.sin, s.vx, s.vy, s.half_length, s.half_width, margin, reach});
  }
  return near;
}

void GivingWay::worst_of(const DirectionTask& task, float share, const Parameters& parameters,
                         std::size_t first, std::size_t count, const DirectionKernel& kernel) {
  const PacedWalk walk{share,
                       static_cast<float>(parameters.discomfort_horizon),
                       static_cast<float>(parameters.relaxation_time),
                       vx_,
                       vy_,
                       stop_};
  std::fill(discomfort_ + first, discomfort_ + first + count, 0.0F);
  for (const VehicleFelt& vehicle : vehicles_) {
    kernel.discomfort(task, vehicle, walk, first, count, discomfort_);
  }
}

bool GivingWay::comfortable(const DirectionTask& task, const DirectionChoice& known,
                            const Parameters& parameters, const DirectionKernel& kernel) {
  const std::size_t first = known.index / kDirectionGroup * kDirectionGroup;
  // Nothing stops it within the time that counts: when something would elsewhere is not asked yet.
  if (known.time >= static_cast<float>(parameters.discomfort_horizon)) {
    std::fill(stop_ + first, stop_ + first + kDirectionGroup, kNever);
    worst_of(task, 1.0F, parameters, first, kDirectionGroup, kernel);
    if (discomfort_[known.index] == 0.0F) return true;
  }
  kernel.times_of(task, task.still_discs, task.still_faces, first, kDirectionGroup, stop_);
  worst_of(task, 1.0F, parameters, first, kDirectionGroup, kernel);
  return discomfort_[known.index] == 0.0F;
}

void GivingWay::price(const DirectionTask& task, const Parameters& parameters, std::size_t first,
                      float most, const DirectionKernel& kernel) {
  kernel.times_of(task, task.still_discs, task.still_faces, first, kDirectionGroup, stop_);
  const float unit = task.horizon * task.horizon;  // d_max² over V²
  const float discomfort = unit * static_cast<float>(parameters.discomfort);
  const float slowing = unit * static_cast<float>(parameters.slowing_cost);
  for (const float share : kShares) {
    const float slow = slowing * (1.0F - share) * (1.0F - share);
    const float dearest = *std::max_element(cost_ + first, cost_ + first + kDirectionGroup);
    // Slower still costs more than what there is, or more than may be spent.
    if (slow >= dearest || slow > most) return;
    worst_of(task, share, parameters, first, kDirectionGroup, kernel);
    for (std::size_t k = first; k < first + kDirectionGroup; ++k) {
      const float cost = task.cost[k] + discomfort * discomfort_[k] + slow;
      const bool better = cost < cost_[k];
      cost_[k] = better ? cost : cost_[k];
      share_[k] = better ? share : share_[k];
    }
  }
}

PacedChoice GivingWay::choose(const Candidates& candidates, const DirectionTask& task,
                              const Parameters& parameters, DirectionChoice known,
                              const DirectionKernel& kernel) {
  std::fill(cost_, cost_ + candidates.padded(), kNever);
  // First the group of what is known: its value is a bound from then on.
  const std::size_t start = known.index / kDirectionGroup * kDirectionGroup;
  price(task, parameters, start, kNever, kernel);
  known.value += cost_[known.index];
  auto ask = [&](std::size_t first, float most) {
    if (first == start) return;
    price(task, parameters, first, most + kSlack * task.horizon * task.horizon, kernel);
  };
  const DirectionPrices prices{cost_,
                               [](void* asker, std::size_t first, float most) {
                                 (*static_cast<decltype(ask)*>(asker))(first, most);
                               },
                               &ask};
  known = kernel.choose_priced(task, prices, known);
  return {known, share_[known.index]};
}

}  // namespace pedzone
