// How a run goes on: what is in the zones, over time.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "conflict/tracker.hpp"
#include "study/measure/walkers.hpp"

namespace pedzone::study {

inline constexpr double kWindow = 10.0;  ///< [s]

class RunSeries {
 public:
  /// Must outlive it.
  explicit RunSeries(const std::vector<Zone>& zones) : zones_(zones) {}

  /// Takes in the step at `time` [s], `dt` [s] after the one before. `density(i)` [1/m²]: that the
  /// i-th walker is in.
  template <typename Density>
  void step(double time, double dt, std::span<const Walker> walkers,
            std::span<const VehicleSample> vehicles, const Density& density) {
    Window& window = window_at(time, dt);
    for (std::size_t i = 0; i < walkers.size(); ++i) {
      if (walkers[i].counts()) add(window.persons, dt, walkers[i].speed, density(i));
    }
    for (const VehicleSample& vehicle : vehicles) {
      if (zone_at(zones_, vehicle.centre) != Walker::kNowhere) {
        add(window.vehicles, dt, vehicle.velocity.norm(), 0.0);
      }
    }
  }

  /// The table (results/run_tables.hpp), a row for each window of kWindow. Speeds and density are
  /// empty where nobody was.
  std::string csv() const;
  /// Appends space.peak: the greatest mean of a window of the density met.
  void finish(std::map<std::string, double>& values) const;

 private:
  struct Sums {
    double time = 0.0;      ///< [s]
    double covered = 0.0;   ///< [m]
    double crowding = 0.0;  ///< [s/m²]
  };
  struct Window {
    double begin = 0.0, length = 0.0;  ///< [s]; length: as far as the run has come
    Sums persons, vehicles;
  };

  Window& window_at(double time, double dt);
  static void add(Sums& sums, double dt, double speed, double density);

  const std::vector<Zone>& zones_;
  std::vector<Window> windows_;
};

}  // namespace pedzone::study
