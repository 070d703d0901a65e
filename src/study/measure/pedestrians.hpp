// The people on foot in a time step, with what all measures of people need to know of them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "conflict/tracker.hpp"
#include "study/measure/tripinfo_reader.hpp"
#include "world/speeds.hpp"

namespace pedzone::study {

struct Pedestrian {
  std::uint32_t person = 0;         ///< index into Trips::persons
  const WalkStage* walk = nullptr;  ///< under way; null: waits for a ride or stops as planned
  Vec2 at = Vec2::Zero();           ///< [m]
  double speed = 0.0;               ///< [m/s] as SUMO says
  std::string_view edge = {};       ///< that SUMO has it on; valid in this step
};

class Pedestrians {
 public:
  /// Must outlive it.
  explicit Pedestrians(const Trips& trips);

  /// Who is on foot at `time` [s]. Throws InputError for somebody without a trip.
  std::span<const Pedestrian> at(double time, std::span<const PersonSample> persons);

 private:
  const WalkStage* walk_of(std::uint32_t person, double time);

  const Trips& trips_;
  std::unordered_map<std::string_view, std::uint32_t> index_;
  std::vector<std::uint32_t> stage_;  ///< by person: the walk that may be under way
  std::vector<Pedestrian> pedestrians_;
};

}  // namespace pedzone::study
