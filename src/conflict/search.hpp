// Who may have to do with a vehicle: told at a glance, since most have not.
#pragma once

#include <cstdint>

#include "conflict/conflict.hpp"
#include "conflict/passing.hpp"

namespace pedzone {

/// [m] a pair as near as this is followed whatever its TTC, for its clearance. Assumed.
inline constexpr double kNear = 2.0;

/// A person by where it is.
struct PersonRow {
  Vec2 at, velocity;  ///< [m], [m/s]
  double radius;      ///< [m]
  double travelled;   ///< [m] within the memory
  double moved;       ///< [m] in this step
  std::uint32_t place;
};

/// The most that any person of the step does.
struct PersonExtremes {
  double speed = 0.0, radius = 0.0, travelled = 0.0, moved = 0.0;
  void take(const PersonRow& person);
};

/// Leaves out persons who cannot matter to a vehicle: cheap tests with circles about the bodies,
/// and with a box about the places where the vehicle has been. It may keep somebody who does not
/// matter; it never leaves out somebody who does.
class Search {
 public:
  Search(const Trail<VehiclePose>& trail, const Vec2& velocity, const Sizes& sizes,
         const PersonExtremes& most, const ConflictLimits& limits);

  /// Whoever lies farther away than this from here in any direction cannot matter.
  const Vec2& centre() const { return centre_; }
  double reach() const { return reach_; }

  /// What a person may have to do with the vehicle.
  struct Reasons {
    bool near;    ///< as near as kNear in this step
    bool course;  ///< on a collision course, within the horizon
    Order order;  ///< at a place where the other has been
    bool any() const { return near || course || order.vehicle_first || order.person_first; }
  };
  Reasons look_at(const PersonRow& person) const;

 private:
  bool has_been_at(const PersonRow& person, const Vec2& to) const;
  bool on_collision_course(const PersonRow& person, const Vec2& to, double room) const;

  Vec2 centre_, axis_, velocity_;
  double body_;                                    ///< [m] centre to corner
  double moved_ = 0.0;                             ///< [m] by a corner in this step
  double horizon_;                                 ///< [s]
  double reach_ = 0.0;                             ///< [m]
  Vec2 low_ = Vec2::Zero(), high_ = Vec2::Zero();  ///< [m] where it was, in its frame
};

}  // namespace pedzone
