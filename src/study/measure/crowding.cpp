#include "study/measure/crowding.hpp"

#include <algorithm>

namespace pedzone::study {
namespace {

/// [m²] per person at least for levels A to E (Fruin 1971, Pedestrian Planning and Design,
/// walkways: 35, 25, 15, 10 and 5 square feet).
constexpr double kSpace[] = {3.25, 2.32, 1.39, 0.93, 0.46};

}  // namespace

int level_of_service(double density) {
  const auto enough = [density](double space) { return density * space <= 1.0; };
  return static_cast<int>(std::ranges::find_if(kSpace, enough) - std::begin(kSpace));
}

void Crowding::add(const Presence& presence) {
  if (!presence.walks()) return;
  const double dt = presence.step.dt, density = presence.closeness.density;
  time_ += dt;
  density_time_ += density * dt;
  level_time_[level_of_service(density)] += dt;
  if (presence.closeness.jammed) jammed_ += dt;
}

void Crowding::finish(std::map<std::string, double>& values) const {
  if (time_ <= 0.0) return;
  values["space.density"] = density_time_ / time_;
  for (std::size_t i = 0; i < level_time_.size(); ++i) {
    values[std::string("space.level") + static_cast<char>('A' + i)] = level_time_[i] / time_;
  }
  values["space.jammed"] = jammed_ / time_;
}

}  // namespace pedzone::study
