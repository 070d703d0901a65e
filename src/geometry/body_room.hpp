// Where the centre of a body can be.
#pragma once

#include "geometry/polygon.hpp"

namespace pedzone {

/// The region shrunk by `clearance` [m], except round passages narrower than twice that: there it
/// is shrunk by `least` [m] only, so that what is wider than 2 · `least` stays passable. Corners
/// are mitred (Corners::kMitred) but in narrow places.
Region body_room(const Region& walkable, double clearance, double least);

}  // namespace pedzone
