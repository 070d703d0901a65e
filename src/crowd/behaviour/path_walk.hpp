// The user's waypoints: a person comes by them in turn, then goes to its destination.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Plans the way of row i from where it stands: to the current waypoint of its path, if any is
/// left, else to `destination`. It has not arrived.
void start_way(const CrowdState& crowd, std::size_t i, const Destination& destination, Ways ways);

/// Whether who moves from `from` to `to` [m] comes by the waypoint: within its radius and with
/// nothing but air between, for who passes outside the wall of a yard has not been inside.
bool comes_by(const WallIndex& walls, const Waypoint& waypoint, const Vec2& from, const Vec2& to);

/// Row i, which has a path, goes on to the next waypoint or, after the last, to its destination.
/// From there on it is a person without a path.
void leave_waypoint(const CrowdState& crowd, std::size_t i, Ways ways);

}  // namespace pedzone
