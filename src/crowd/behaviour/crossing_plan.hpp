// Where somebody crosses: over the next street, or at the junctions.
#pragma once

#include <functional>
#include <optional>

#include "crowd/behaviour/gaps.hpp"
#include "crowd/state/state.hpp"

namespace pedzone {

/// Whether row i crosses near a signal, too.
bool is_impulsive(const CrowdState& crowd, std::size_t i);

/// After row i has planned its way to `destination` [m]: weighs crossing one street of the zone
/// between the junctions against that. Where this takes less time, the route leads to the kerb
/// first. Else it crosses only if a gap comes while it walks along.
void plan_crossing(const CrowdState& crowd, std::size_t i, const Destination& destination,
                   Ways ways);

/// Row i goes by the junctions after all.
void go_by_nodes(const CrowdState& crowd, std::size_t i, Ways ways);

/// The route of row i leads straight across its street, at s [m].
void head_across(const CrowdState& crowd, std::size_t i, double s, Route& route);

/// That of row i, which is on the carriageway, leads along it to s, then over.
void head_along(const CrowdState& crowd, std::size_t i, double s, Route& route);

/// A line straight across a street.
struct CrossingLine {
  double s = 0.0;    ///< [m]
  double way = 0.0;  ///< [m] to it, > 0
};

/// The line nearest to s on which row i may cross its street and that is not barred, in steps of
/// `step` up to `farthest` [m] to either side.
std::optional<CrossingLine> nearest_line(const CrowdState& crowd, std::size_t i, double s,
                                         double step, double farthest,
                                         const std::function<bool(double s)>& is_barred);

/// Row i goes to the nearest place of the kerb that is not barred.
void move_along_kerb(const CrowdState& crowd, std::size_t i,
                     const std::function<bool(double s)>& is_barred, Ways ways);

/// The walk of row i straight across its street from where it is, start-up and margin as it takes
/// them at present.
CrossingWalk walk_across(const CrowdState& crowd, std::size_t i, double s);

/// How row i walks over any carriageway when it has waited for so long [s]: where is left open.
CrossingWalk walk_after(const CrowdState& crowd, std::size_t i, double waited);

/// Whether row i walks already: it loses no time to start.
bool is_walking(const CrowdState& crowd, std::size_t i);

/// [m] of the kerb where row i waits, and of the ground where it gets to.
Vec2 kerb_before(const CrowdState& crowd, std::size_t i, double s);
Vec2 kerb_beyond(const CrowdState& crowd, std::size_t i, double s);

}  // namespace pedzone
