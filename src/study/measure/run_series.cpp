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

bool in_any(const std::vector<Zone>& zones, const Vec2& at) {
  return std::ranges::any_of(zones, [&at](const Zone& zone) {
    return zone.walls.inside(at) || (!zone.streets.empty() && zone.street_walls.inside(at));
  });
}

}  // namespace

double RunSeries::begin_of_window(double time) { return std::floor(time / kWindow) * kWindow; }

void RunSeries::step(const RunStep& step, std::span<const VehicleSample> vehicles) {
  const double begin = begin_of_window(step.time);
  if (windows_.empty() || windows_.back().begin != begin) windows_.push_back({begin, 0.0, {}, {}});
  Window& window = windows_.back();
  window.length += step.dt;
  for (const VehicleSample& vehicle : vehicles) {
    if (vehicle.part == 0 && in_any(zones_, vehicle.centre)) {
      add(window.vehicles, step.dt, vehicle.velocity.norm(), 0.0);
    }
  }
}

void RunSeries::add(const Presence& presence) {
  if (!presence.walks()) return;
  const double begin = begin_of_window(presence.step.time);
  const auto window = std::ranges::lower_bound(windows_, begin, {}, &Window::begin);
  add(window->persons, presence.step.dt, presence.pedestrian.speed, presence.closeness.density);
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
