// A run as pictures need it: everybody's way with what is known of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "crowd/crowd.hpp"
#include "world/activities.hpp"

namespace pedzone {

/// A person in one step.
struct PersonMoment {
  std::uint32_t step = 0;        ///< index into Recording::times
  float heading = 0.0F;          ///< [rad] where it faces
  float speed = 0.0F;            ///< [m/s] >= 0
  std::optional<Motion> motion;  ///< nothing where the recording does not tell it
  Activity activity = Activity::kNone;
  Vec2 position = Vec2::Zero();  ///< [m] centre of the body
  bool by_sumo = false;          ///< SUMO walks it, in a run of pedzone's
};

/// A vehicle in one step.
struct VehicleMoment {
  std::uint32_t step = 0;      ///< index into Recording::times
  float heading = 0.0F;        ///< [rad]
  float speed = 0.0F;          ///< [m/s] >= 0
  Vec2 centre = Vec2::Zero();  ///< [m] of the rectangle, not SUMO's front bumper
};

/// Somebody's moments ascend by step. Steps may be missing: it rode, or was not recorded then.
struct RecordedPerson {
  std::string id;
  std::string profile, group;         ///< pedzone.profile, pedzone.group; empty: none or not known
  double length = 0.0, width = 0.0;   ///< [m] > 0 of the body
  double radius = 0.0;                ///< [m] > 0 of the body as a disc
  std::vector<PersonMoment> moments;  ///< never empty
};
struct RecordedVehicle {
  std::string id, type;
  double length = 0.0, width = 0.0;    ///< [m] > 0
  std::vector<VehicleMoment> moments;  ///< never empty
  int part = 0;  ///< of a vehicle that bends, each part is by itself; 0: the first, or all of it
};

struct Recording {
  double begin = 0.0, end = 0.0;  ///< [s] what is shown of the file, be anybody there or not: from
                                  ///< its first step to the end of its last
  std::vector<double> times;              ///< [s] ascending: all steps in which anybody was there
  std::vector<RecordedPerson> persons;    ///< in the order of their first appearance
  std::vector<RecordedVehicle> vehicles;  ///< likewise
};

/// The last moment of a track not later than `step`; null where there is none.
template <class Moment>
const Moment* moment_until(const std::vector<Moment>& moments, std::uint32_t step) {
  const auto after = std::ranges::upper_bound(moments, step, {}, &Moment::step);
  return after == moments.begin() ? nullptr : &*(after - 1);
}

/// The moment of a track at `step`; null where it is not there.
template <class Moment>
const Moment* moment_at(const std::vector<Moment>& moments, std::uint32_t step) {
  const Moment* moment = moment_until(moments, step);
  return moment != nullptr && moment->step == step ? moment : nullptr;
}

}  // namespace pedzone
