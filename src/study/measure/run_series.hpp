// How a run goes on: what is in the zones, over time.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "conflict/tracker.hpp"
#include "study/measure/zone_stays.hpp"

namespace pedzone::study {

inline constexpr double kWindow = 10.0;  ///< [s]

class RunSeries {
 public:
  /// Must outlive it.
  explicit RunSeries(const std::vector<Zone>& zones) : zones_(zones) {}

  /// Takes in a step. Vehicles are in a zone by their middle's place.
  void step(const RunStep& step, std::span<const VehicleSample> vehicles);
  /// Takes in somebody in a zone, in a step that it was given: who walks counts.
  void add(const Presence& presence);

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

  static double begin_of_window(double time);
  static void add(Sums& sums, double dt, double speed, double density);

  const std::vector<Zone>& zones_;
  std::vector<Window> windows_;  ///< by begin
};

}  // namespace pedzone::study
