// Vehicles that drive beside people's ground, not on it.
//
//      [ car ] -------------------------->      its band, as far as its way is known
//      == kerb ===========================
//        x                                      nobody here need give way to it
#pragma once

#include "geometry/wall_index.hpp"
#include "world/snapshot.hpp"

namespace pedzone {

/// Whether the vehicle keeps off the ground inside the walls: the band that it covers from its rear
/// to the end of its way (where that is unknown: straight on, as far as it drives in 4.5 s), 0.3 m
/// on each side included.
bool keeps_apart(const WallIndex& walls, const VehicleState& vehicle);

}  // namespace pedzone
