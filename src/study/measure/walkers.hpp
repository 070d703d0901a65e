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
#include "zone/zone.hpp"

namespace pedzone::study {

struct Walker {
  static constexpr int kNowhere = -1;
  std::uint32_t person = 0;         ///< index into Trips::persons
  const WalkStage* walk = nullptr;  ///< under way; null: waits for a ride or stops as planned
  int zone = kNowhere;              ///< index of the zone in whose walkable area it is
  Vec2 at = Vec2::Zero();           ///< [m]
  double speed = 0.0;               ///< [m/s] as SUMO says
  std::string_view edge = {};       ///< that SUMO has it on
  bool counts() const { return walk != nullptr && zone != kNowhere; }
};

class Walkers {
 public:
  /// Both must outlive it.
  Walkers(const Trips& trips, const std::vector<Zone>& zones);

  /// Who is on foot at `time` [s]. Throws InputError for somebody without a trip.
  std::span<const Walker> at(double time, std::span<const PersonSample> persons);

 private:
  const WalkStage* walk_of(std::uint32_t person, double time);

  const Trips& trips_;
  const std::vector<Zone>& zones_;
  std::unordered_map<std::string_view, std::uint32_t> index_;
  std::vector<std::uint32_t> stage_;  ///< by person: the walk that may be under way
  std::vector<Walker> walkers_;
};

/// Index of the first zone in whose walkable area a place is, or Walker::kNowhere.
int zone_at(const std::vector<Zone>& zones, const Vec2& at);

}  // namespace pedzone::study
