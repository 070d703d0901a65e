#include "study/measure/run_series.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "results/run_tables.hpp"

namespace pedzone::study {
namespace {

std::optional<double> mean(double sum, double time) {
  return time > 0.0 ? std::optional(sum / time) : std::nullopt;
}

}  // namespace

RunSeries::Window& RunSeries::window_at(double time, double dt) {
  const double begin = std::floor(time / kWindow) * kWindow;
  if (windows_.empty() || windows_.back().begin != begin) windows_.push_back({begin, 0.0, {}, {}});
  windows_.back().length += dt;
  return windows_.back();
}

void RunSeries::add(Sums& sums, double dt, double speed, double density) {
  sums.time += dt;
  sums.covered += speed * dt;
  sums.crowding += density * dt;
}

std::string RunSeries::csv() const {
  std::string text = series_table().header();
  for (const Window& window : windows_) {
    const Sums &people = window.persons, &vehicles = window.vehicles;
    if (window.length <= 0.0) continue;
    series_table().append(
        text, {window.begin, mean(people.time, window.length), mean(people.covered, people.time),
               mean(people.crowding, people.time), mean(vehicles.time, window.length),
               mean(vehicles.covered, vehicles.time)});
  }
  return text;
}

void RunSeries::finish(std::map<std::string, double>& values) const {
  for (const Window& window : windows_) {
    const auto density = mean(window.persons.crowding, window.persons.time);
    if (!density) continue;
    double& peak = values["space.peak"];
    peak = std::max(peak, *density);
  }
}

}  // namespace pedzone::study
