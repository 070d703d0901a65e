// Zone lanes that run on a road that stays SUMO's, as maps have them where a square or a cycle
// path is drawn over a street.
#pragma once

#include <string>
#include <vector>

#include "zone/selection.hpp"

namespace pedzone {

/// One warning for each lane of the selection of which a good part lies on a lane for vehicles
/// only: its persons meet vehicles there that SUMO keeps apart from them.
void warn_of_roads_under_lanes(const Network& network, const Selection& selection,
                               std::vector<std::string>& warnings);

}  // namespace pedzone
