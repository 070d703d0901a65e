// The room ahead of itself that a vehicle claims where people hold it up.
#pragma once

#include <optional>

#include "world/snapshot.hpp"

namespace pedzone {

/// A place in the room that a vehicle claims.
struct ClaimPlace {
  double ahead = 0.0;    ///< [m] of the front bumper, along the vehicle's way
  double lateral = 0.0;  ///< [m] of the way's middle, positive to the left
  Vec2 along;            ///< unit vector of the way there
};

/// Where in the claim a body is whose centre keeps less than `margin` [m] to the swept area;
/// nothing outside.
std::optional<ClaimPlace> place_in_claim(const VehicleState& vehicle, const Vec2& point,
                                         double margin);

}  // namespace pedzone
