#include "crowd/behaviour/path_walk.hpp"

#include "crowd/behaviour/crossing_plan.hpp"
#include "geometry/segment.hpp"

namespace pedzone {
namespace {

/// Plans the way of row i to `destination`, and starts its clocks anew.
void plan_way(const CrowdState& crowd, std::size_t i, const Destination& destination, Ways ways) {
  WalkState& walker = ways.walkers[i];
  const Vec2 here = crowd.position(i);
  if (crowd.is_over(i)) {  // gets over first
    ways.crossing(i).destination = destination;
    return;
  }
  plan(crowd.zone, here, crowd.persons.radius[i], destination, walker.route);
  plan_crossing(crowd, i, destination, ways);
  walker.planned = crowd.clock.substep;
  walker.entered = walker.arrived = walker.gave_up = false;
  walker.start_clocks();
  ways.jams[walker.handle] = {};
  const Vec2 to_goal = heading_point(walker.route, here) - here;
  ways.persons.goal_direction[i] = angle_of(to_goal);
  ways.persons.goal_distance[i] = to_goal.norm();
}

/// Plans the way to the current waypoint, or to the first one after it to which there is any way:
/// walls do not move, so that patience would not help.
void plan_leg(const CrowdState& crowd, std::size_t i, Ways ways) {
  PathMemory& path = ways.paths[crowd.handle(i)];
  for (; path->next < path->waypoints.size(); ++path->next) {
    const Vec2& at = path->current().at;
    plan_way(crowd, i, {at, at}, ways);
    if (crowd.walkers[i].route.found) return;
  }
  const Destination destination = path->destination;
  path.reset();
  plan_way(crowd, i, destination, ways);
}

}  // namespace

void start_way(const CrowdState& crowd, std::size_t i, const Destination& destination, Ways ways) {
  ways.walkers[i].waits = false;
  const PathMemory& path = ways.paths[crowd.handle(i)];
  if (path == nullptr) {
    plan_way(crowd, i, destination, ways);
  } else {
    path->destination = destination;
    plan_leg(crowd, i, ways);
  }
}

bool comes_by(const WallIndex& walls, const Waypoint& waypoint, const Vec2& from, const Vec2& to) {
  // Between two substeps a person can pass a small radius.
  const Vec2 nearest = nearest_on(from, to, waypoint.at);
  return (nearest - waypoint.at).norm() <= waypoint.radius && walls.free_line(nearest, waypoint.at);
}

void leave_waypoint(const CrowdState& crowd, std::size_t i, Ways ways) {
  ++ways.paths[crowd.handle(i)]->next;
  plan_leg(crowd, i, ways);
}

}  // namespace pedzone
