#include "study/measure/closeness.hpp"

#include <algorithm>
#include <numeric>

namespace pedzone::study {

double circle_density(int persons) { return persons / (kPi * kCircle * kCircle); }

ClosenessMeter::ClosenessMeter(const Trips& trips) : standing_(trips.persons.size()) {}

std::span<const Closeness> ClosenessMeter::of(double dt, std::span<const Walker> walkers) {
  ++step_;
  stuck_.clear();
  for (const Walker& walker : walkers) stuck_.push_back(stands_long(dt, walker));
  count_near(walkers);
  closeness_.clear();
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    closeness_.push_back(
        {circle_density(1 + near_[i].all), stuck_[i] && near_[i].stuck >= kJamOthers});
  }
  return closeness_;
}

bool ClosenessMeter::stands_long(double dt, const Walker& walker) {
  Standing& standing = standing_[walker.person];
  const bool stays = standing.seen + 1 == step_;
  const bool stands = walker.walk != nullptr && walker.speed < kHaltingSpeed;
  standing.time = stays && stands ? standing.time + dt : 0.0;
  standing.seen = step_;
  return standing.time >= kJamTime;
}

void ClosenessMeter::count_near(std::span<const Walker> walkers) {
  near_.assign(walkers.size(), {});
  order_.resize(walkers.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::ranges::sort(order_, {}, [&](std::uint32_t i) { return walkers[i].at.x(); });
  for (auto a = order_.begin(); a != order_.end(); ++a) {
    const Vec2& at = walkers[*a].at;
    for (auto b = a + 1; b != order_.end() && walkers[*b].at.x() - at.x() <= kCircle; ++b) {
      if ((walkers[*b].at - at).squaredNorm() > kCircle * kCircle) continue;
      ++near_[*a].all;
      ++near_[*b].all;
      near_[*a].stuck += stuck_[*b];
      near_[*b].stuck += stuck_[*a];
    }
  }
}

}  // namespace pedzone::study
