#include "study/measure/closeness.hpp"

#include <algorithm>
#include <numeric>

namespace pedzone::study {

double circle_density(int persons) { return persons / (kPi * kCircle * kCircle); }

ClosenessMeter::ClosenessMeter(const Trips& trips) : standing_(trips.persons.size()) {}

std::span<const Closeness> ClosenessMeter::of(double dt, std::span<const Pedestrian> pedestrians) {
  ++step_;
  stuck_.clear();
  for (const Pedestrian& pedestrian : pedestrians) stuck_.push_back(stands_long(dt, pedestrian));
  count_near(pedestrians);
  closeness_.clear();
  for (std::size_t i = 0; i < pedestrians.size(); ++i) {
    closeness_.push_back(
        {circle_density(1 + near_[i].all), stuck_[i] && near_[i].stuck >= kJamOthers});
  }
  return closeness_;
}

bool ClosenessMeter::stands_long(double dt, const Pedestrian& pedestrian) {
  Standing& standing = standing_[pedestrian.person];
  const bool stays = standing.seen + 1 == step_;
  const bool stands = pedestrian.walk != nullptr && pedestrian.speed < kHaltingSpeed;
  standing.time = stays && stands ? standing.time + dt : 0.0;
  standing.seen = step_;
  return standing.time >= kJamTime;
}

void ClosenessMeter::count_near(std::span<const Pedestrian> pedestrians) {
  near_.assign(pedestrians.size(), {});
  order_.resize(pedestrians.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::ranges::sort(order_, {}, [&](std::uint32_t i) { return pedestrians[i].at.x(); });
  for (auto a = order_.begin(); a != order_.end(); ++a) {
    const Vec2& at = pedestrians[*a].at;
    for (auto b = a + 1; b != order_.end() && pedestrians[*b].at.x() - at.x() <= kCircle; ++b) {
      if ((pedestrians[*b].at - at).squaredNorm() > kCircle * kCircle) continue;
      ++near_[*a].all;
      ++near_[*b].all;
      near_[*a].stuck += stuck_[*b];
      near_[*b].stuck += stuck_[*a];
    }
  }
}

}  // namespace pedzone::study
