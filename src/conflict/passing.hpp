// PET: how long after one of two has left a place the other enters it, from the ways that both
// have gone with their shapes.
#pragma once

#include <limits>
#include <optional>

#include "conflict/approach.hpp"
#include "conflict/poses.hpp"
#include "conflict/trail.hpp"

namespace pedzone {

/// A place that both have been at.
struct Passing {
  double gap = 0.0;           ///< [s] > 0: the person came after the vehicle; < 0: before it
  Vec2 place = Vec2::Zero();  ///< [m] centre of the person when it was there
  double pet() const { return gap < 0.0 ? -gap : gap; }
};

/// The least time between one leaving a place and the other entering it, where both were while the
/// person went from `p0` to `p1` and the vehicle from `v0` to `v1`; nothing where no place is in
/// both ways. Both move evenly, and the vehicle turns evenly. The shapes meet in the rectangle
/// grown by the disc, its corners cut as an octagon's (2 cm outside the round ones).
std::optional<Passing> closest_in_time(const PersonPose& p0, const PersonPose& p1,
                                       const VehiclePose& v0, const VehiclePose& v1,
                                       const Sizes& sizes);

/// The least clearance while the person goes from `p0` to `p1` and the vehicle, which turns evenly,
/// at the same time from `v0` to `v1`; and the share of that time at which they first touch.
Closest closest_on_ways(const PersonPose& p0, const PersonPose& p1, const VehiclePose& v0,
                        const VehiclePose& v1, const Sizes& sizes);

/// Which of the two may have been first at a place; who was not need not be looked for.
struct Order {
  bool vehicle_first = true, person_first = true;
};

/// The same of each one's newest piece and the other's whole trail, where it is less than `below`
/// [s]. Ways along each other do not count (directions less than kSameWay apart): behind somebody
/// who walks or drives ahead one always enters what the other has left.
std::optional<Passing> latest_passing(const Trail<PersonPose>& person,
                                      const Trail<VehiclePose>& vehicle, const Sizes& sizes,
                                      double below = std::numeric_limits<double>::infinity(),
                                      const Order& order = {});

/// [rad] directions that differ by less are the same way, by more than π less it the opposite one.
/// Assumed: the quarter turn that lies about each axis.
inline constexpr double kSameWay = kPi / 4.0;

}  // namespace pedzone
