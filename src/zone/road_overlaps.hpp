// Zone lanes that run on a road that stays SUMO's, as maps have them where a square or a cycle
// path is drawn over a street.
#pragma once

#include <string>
#include <vector>

#include "zone/selection.hpp"

namespace pedzone {

/// Removes the edges from the selection on which people would walk along under a road for 5 m and
/// more, with no room beside it: neither they nor its vehicles would get past each other, where
/// plain SUMO lets them walk through each other. One warning each. Not edges with open space or
/// walkable polygons round them; and not where nothing would be left.
void leave_out_covered(const Network& network, const ZoneSpec& spec, Selection& selection,
                       std::vector<std::string>& warnings);

/// One warning for each lane of the selection of which a good part lies on a lane for vehicles
/// only: its persons meet vehicles there that SUMO keeps apart from them.
void warn_of_roads_under_lanes(const Network& network, const Selection& selection,
                               std::vector<std::string>& warnings);

}  // namespace pedzone
