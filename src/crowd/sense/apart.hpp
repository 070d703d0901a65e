// Vehicles that drive beside people's ground, and where they will drive on it.
//
//      [ car ] -------------------------->      its band, as far as its way is known
//      == kerb =====================+ zebra +
//        x                          | ground|   nobody here need give way to it yet
#pragma once

#include "geometry/wall_index.hpp"
#include "world/snapshot.hpp"

namespace pedzone {

/// The box [m] around the ground inside the walls that the vehicle is about to drive on: by the
/// band from its rear to the end of its way (where that is unknown: straight on, as far as it
/// drives in 4.5 s), 0.3 m on each side included. Everywhere, where it is on such ground already;
/// empty, where it keeps off it.
Eigen::AlignedBox2d ground_ahead(const WallIndex& walls, const VehicleState& vehicle);

}  // namespace pedzone
