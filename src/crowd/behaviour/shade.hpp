// Ways through the shade, in weather that makes people seek it.
#pragma once

#include <vector>

#include "crowd/state/person.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// Where a person on its way from `from` to `destination` enters and leaves the shade that costs it
/// the least detour; nothing where all are too far aside, or the zone's weather has no such shades.
std::vector<Waypoint> way_through_shade(const Zone& zone, const Vec2& from,
                                        const Destination& destination);

}  // namespace pedzone
