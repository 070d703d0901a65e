// People on the edges of zones, interval by interval, as SUMO's edgeData tells of vehicles.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "results/complete_file.hpp"
#include "zone/edge_finder.hpp"

namespace pedzone {

/// Somebody in one step.
struct PersonOnEdge {
  std::string_view person;  ///< id
  int zone = 0;             ///< index into the zones
  Vec2 at = Vec2::Zero();   ///< [m]
  double speed = 0.0;       ///< [m/s]
  double free_speed = 1.0;  ///< [m/s] that it walks with nobody in its way
};

/// Writes SUMO's <meandata> (meandata_file.xsd). Of an edge: sampledSeconds [s], traveltime [s],
/// density [persons/km of the edge], waitingTime [s] slower than kHaltingSpeed, timeLoss [s] over
/// walking at the free speed, speed [m/s], entered and left [persons].
class EdgeDataWriter {
 public:
  /// `period` [s] > 0 of an interval; unset: the whole run is one. Throws InputError as
  /// CompleteFile.
  EdgeDataWriter(const std::string& path, const std::string& option, std::optional<double> period);

  /// Before the first step, at `time` [s]. Both must outlive it.
  void begin(const Network& network, const std::vector<Zone>& zones, double time);
  /// A step of `dt` [s] from `time` [s] on.
  void step(double time, double dt, std::span<const PersonOnEdge> persons);
  void finish();

 private:
  struct Sums {
    double time = 0.0, waiting = 0.0;  ///< [s]
    double distance = 0.0;             ///< [m]
    double free_time = 0.0;            ///< [s] that distance at the free speed
    long entered = 0, left = 0;
  };
  struct Track {
    int edge = -1;
    double seen = 0.0;  ///< [s] latest step
  };

  void add(double dt, int edge, const PersonOnEdge& person);
  void forget_gone(double time);
  void write_interval();
  std::string attributes(const Sums& sums, double length) const;

  CompleteFile file_;
  std::optional<double> period_;
  const Network* network_ = nullptr;
  std::vector<EdgeFinder> finders_;  ///< of each zone
  std::vector<int> edges_;           ///< of all zones, ascending
  std::unordered_map<int, Sums> sums_;
  std::unordered_map<std::string, Track> tracks_;
  double begin_ = 0.0, end_ = 0.0;  ///< [s] of the interval, as far as it has come
};

}  // namespace pedzone
