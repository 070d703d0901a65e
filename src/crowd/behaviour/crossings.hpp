// Crossing streets between the junctions: when people step out, and how they get over.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Whether row i walks along a street that it may cross right there, or is on it.
bool is_at_street(const CrowdState& crowd, std::size_t i);

/// Somebody is at the end of the route that leads it to a kerb: it waits there.
void come_to_kerb(StreetCrossing& crossing);

/// Who steps out, goes by the junctions after all, or has got over, in a substep of `dt` [s].
void cross_streets(const CrowdState& crowd, double dt, Ways ways,
                   std::vector<CrossingBegun>& begun);

/// Who is on the carriageway goes straight over.
void propose_crossings(const CrowdState& crowd, Proposals& proposals);

/// Who waits at the kerb stands; on the carriageway nothing holds people but vehicles.
void restrain_crossings(const CrowdState& crowd, Restraints& restraints);

}  // namespace pedzone
