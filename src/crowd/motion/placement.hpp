// Where somebody who departs inside a zone can stand.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// The free place nearest to `wanted` (inside the walls) for a body of `radius` [m]: none
/// overlaps it there, no wall lies between, and it is at most kPlacementReach away. Where no place
/// is free, the one with most room. The same crowd gives the same place.
Vec2 free_place(const CrowdState& crowd, const Vec2& wanted, double radius);

/// [m] assumed: nobody departs farther than this from where SUMO put it.
constexpr double kPlacementReach = 3.0;

}  // namespace pedzone
