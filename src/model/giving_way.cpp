#include "model/giving_way.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pedzone {
namespace {

constexpr float kSlow[] = {0.5F, 0.0F};  // shares of the speed
constexpr float kMuchFaster = 1.5F;  // assumed: as fast as a vehicle must be to be let past fully;
                                     // who is followed by one no faster walks ahead of it
constexpr float kPassReach = 8.0F;   // [m] measured (CITR, back): farther away nobody slows down
constexpr float kMeetingReach =
    10.0F;                            // [m] measured (CITR, front): farther away nobody slows down
constexpr float kMeetingRamp = 2.0F;  // [m] assumed
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
    const float behind =
        1.0F + static_cast<float>(parameters.room_behind) * std::max(0.0F, cosine_to(s, walker));
    const float margin = usual * behind * caution * std::min(1.0F, s.speed / kFullMarginSpeed);
    if (margin <= 0.0F) continue;
    // The person from the vehicle's centre, in the world's frame.
    const float x = view.x * s.cos - view.y * s.sin, y = view.x * s.sin + view.y * s.cos;
    const float reach = s.reach + margin;
    const float anywhere =
        reach + kMostHurry * walker.speed * (time + glide) + glide * walker.pace();
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

double GivingWay::pace_near(const Walker& walker, std::span<const VehicleView> vehicles,
                            const Parameters& parameters) {
  const auto letting_pass = static_cast<float>(parameters.letting_pass);
  const auto meeting = static_cast<float>(parameters.meeting);
  float most = 0.0F;
  for (const VehicleView& view : vehicles) {
    const VehicleShape& s = *view.shape;
    if (!s.moving() || has_passed(view)) continue;
    const float along = cosine_to(s, walker);
    if (along < 0.0F) {
      const float near = std::clamp((kMeetingReach - view.distance) / kMeetingRamp, 0.0F, 1.0F);
      most = std::max(most, meeting * -along * near);
      continue;
    }
    const float ratio = along * s.speed / walker.speed;
    const float faster = std::clamp((ratio - 1.0F) / (kMuchFaster - 1.0F), 0.0F, 1.0F);
    const float near = std::max(0.0F, 1.0F - view.distance / kPassReach);
    most = std::max(most, letting_pass * along * faster * near);
  }
  return 1.0 - static_cast<double>(most);
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

void GivingWay::try_pace(const DirectionTask& task, float share, float pace,
                         const Parameters& parameters, std::size_t first,
                         const DirectionKernel& kernel) {
  const float unit = task.horizon * task.horizon;
  const float discomfort = unit * static_cast<float>(parameters.discomfort);
  worst_of(task, share, parameters, first, kDirectionGroup, kernel);
  for (std::size_t k = first; k < first + kDirectionGroup; ++k) {
    const float cost = task.cost[k] + discomfort * discomfort_[k] + pace;
    const bool better = cost < cost_[k];
    cost_[k] = better ? cost : cost_[k];
    share_[k] = better ? share : share_[k];
  }
}

void GivingWay::price(const DirectionTask& task, const Parameters& parameters, std::size_t first,
                      float most, const DirectionKernel& kernel) {
  kernel.times_of(task, task.still_discs, task.still_faces, first, kDirectionGroup, stop_);
  const float unit = task.horizon * task.horizon;  // d_max² over V²
  const float slowing = unit * static_cast<float>(parameters.slowing_cost);
  const auto too_dear = [&](float pace) {
    const float dearest = *std::max_element(cost_ + first, cost_ + first + kDirectionGroup);
    return pace >= dearest || pace > most;  // than what there is, or than may be spent
  };
  try_pace(task, 1.0F, 0.0F, parameters, first, kernel);
  const float hurrying =
      unit * static_cast<float>(parameters.hurry_cost) * (hurry_ - 1.0F) * (hurry_ - 1.0F);
  if (hurry_ > 1.0F && !too_dear(hurrying)) {
    try_pace(task, hurry_, hurrying, parameters, first, kernel);
  }
  for (const float share : kSlow) {
    const float slow = slowing * (1.0F - share) * (1.0F - share);
    if (too_dear(slow)) return;
    try_pace(task, share, slow, parameters, first, kernel);
  }
}

PacedChoice GivingWay::choose(const Candidates& candidates, const DirectionTask& task,
                              const Parameters& parameters, const DirectionChoice& known,
                              float hurry, const DirectionKernel& kernel) {
  hurry_ = hurry;
  std::fill(cost_, cost_ + candidates.padded(), kNever);
  // First the group of what is known: its value is a bound from then on.
  const std::size_t start = known.index / kDirectionGroup * kDirectionGroup;
  price(task, parameters, start, kNever, kernel);
  auto ask = [&](std::size_t first, float most) {
    if (first == start) return;
    price(task, parameters, first, most + kSlack * task.horizon * task.horizon, kernel);
  };
  const DirectionPrices prices{cost_,
                               [](void* asker, std::size_t first, float most) {
                                 (*static_cast<decltype(ask)*>(asker))(first, most);
                               },
                               &ask};
  const DirectionChoice best = kernel.choose_priced(task, prices, known);
  return {best, share_[best.index]};
}

}  // namespace pedzone
