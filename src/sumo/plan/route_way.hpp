// The way that a walk's route takes through a zone, and what of it the crowd keeps to: inside a
// street people walk as they like, but along the streets that their route names.
#pragma once

#include <vector>

#include "sumo/plan/zone_route.hpp"

namespace pedzone {

/// The part of a route that pedzone walks somebody along.
struct RoutePart {
  const Network& network;
  const Zone& zone;
  const std::vector<int>& route;  ///< Network edges
  int first = 0, last = 0;        ///< indices into it; the person is on the first
  Vec2 from = Vec2::Zero();       ///< [m] where it is, inside the zone
  Vec2 to = Vec2::Zero();         ///< [m] where it is walked to
};

/// Where [m] SUMO comes from one edge of the part to the next: the end of the one and the begin of
/// the other by turns. Where a walk begins with both sides of a street SUMO walks it by the end
/// that is less of a way.
std::vector<Vec2> ends_of_edges(const RoutePart& part);

/// [m] from where the person is, by those, to where it is walked to.
double length_by(const RoutePart& part, const std::vector<Vec2>& ends);

/// What the person is to come by, with what ends_of_edges() tells of that part:
/// - where the crowd's way would be far shorter than the route, the ends of its edges: somebody
///   takes it for its own sake, there and back, or round a block;
/// - where the crowd's way would lead along other streets, which are as long or less than 6 m
///   longer, the middles of those edges that it would miss.
/// Nothing where the crowd takes a short cut of more than a tenth of the way.
std::vector<Waypoint> waypoints_of(const RoutePart& part, const std::vector<Vec2>& ends);

}  // namespace pedzone
