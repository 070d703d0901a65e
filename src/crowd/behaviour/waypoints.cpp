#include "crowd/behaviour/waypoints.hpp"

#include <algorithm>
#include <cmath>

#include "crowd/behaviour/corners.hpp"
#include "crowd/behaviour/crossings.hpp"
#include "crowd/behaviour/path_walk.hpp"
#include "crowd/state/parallel.hpp"
#include "crowd/state/state.hpp"
#include "geometry/segment.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kAtLine = 0.3;        // [m] assumed: so near, a portal is reached
constexpr double kAtPoint = 0.5;       // [m] assumed: so near, a single point is reached
constexpr double kBodySlack = 0.06;    // [m] numerical: a body that touches a wall on its
                                       // destination has reached it
constexpr double kOnWaypoint = 0.15;   // [m] numerical: on it, whatever is in view
constexpr double kGiveUpWithin = 3.0;  // [m] assumed: a blocked destination is as good as reached
constexpr double kProgress = 0.5;      // [m] assumed: less in `patience` seconds is none
constexpr double kPullMargin = 0.03;   // [m] numerical: beyond the body when a corner is skipped

// Numerical, in substeps: how often a person looks whether it may skip a waypoint, whether it
// still sees its own, and how often at most it plans again. Looking twice as often cuts corners
// by some centimetres more and costs twice as many lines of sight.
constexpr std::uint64_t kLookEvery = 5, kCheckEvery = 10, kPlanEvery = 20;

bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 ab = b - a, cd = d - c;
  return cross(ab, c - a) * cross(ab, d - a) <= 0.0 && cross(cd, a - c) * cross(cd, b - c) < 0.0;
}

/// A portal is reached by crossing it or coming close to it; a point by coming close. Where the
/// destination lies outside the walkable area, the nearest place inside counts.
bool reaches(const Route& route, double radius, const Vec2& from, const Vec2& to) {
  const Vec2 &a = route.destination.a, &b = route.destination.b;
  const double near = std::max(a == b ? kAtPoint : kAtLine, radius + kBodySlack);
  const auto distance = [](const Vec2& point, const Vec2& c, const Vec2& d) {
    return (nearest_on(c, d, point) - point).norm();
  };
  if (distance(to, a, b) <= near || segments_cross(from, to, a, b)) return true;
  const Vec2 aim = nearest_on(route.aim_a, route.aim_b, to);
  return (aim - to).norm() <= near && distance(aim, a, b) > near;
}

/// One person's look at its way.
class Follower {
 public:
  Follower(const CrowdState& crowd, std::size_t i, std::uint64_t substeps, Ways ways)
      : crowd_(crowd),
        row_(i),
        ways_(ways),
        walls_(crowd.zone.walls),
        walker_(ways.walkers[i]),
        route_(walker_.route),
        here_(crowd.position(i)),
        radius_(crowd.persons.radius[i]),
        turn_(crowd.clock.substep + crowd.persons.key[i]),
        substeps_(substeps) {}

  void follow(double dt) {
    if ((heading_point(route_, here_) - here_).norm() <= crowd_.zone.parameters.waypoint_radius) {
      walker_.entered = true;
    }
    if (walker_.entered && !route_.on_last()) take_entered();
    if (!route_.on_last() && due(kLookEvery)) {
      route_.beside = beside_corner(crowd_, row_);
      // Who takes a corner wide turns only there: to turn as soon as the way beyond is in view
      // leads back to the inside.
      if (route_.beside.isZero()) look_ahead();
    }
    if (due(kCheckEvery)) check_sight();
    lose_patience(dt);
  }

 private:
  /// Whether it is this person's turn to look, in one of the substeps.
  bool due(std::uint64_t every) const { return (every - turn_ % every) % every < substeps_; }

  bool sees(const Vec2& point, double clearance) const {
    return walls_.free_line(here_, point, clearance);
  }

  bool sees_point_after(double clearance) const {
    return walls_.free_line(here_, point_after(), clearance, walker_.hiding);
  }

  /// The point that would be headed for if the next waypoint were taken.
  Vec2 point_after() const {
    if (route_.next + 2 < route_.points.size()) return route_.points[route_.next + 1];
    return nearest_on(route_.aim_a, route_.aim_b, here_);
  }

  void take_next(bool in_view) {
    go_on_to(route_, route_.next + 1);
    route_.last_in_view = in_view;
    walker_.entered = false;
  }

  /// The current waypoint was entered: the next one is taken as soon as there is a free way to it,
  /// so that a corner holds nobody and a large radius leads nobody into a wall.
  void take_entered() {
    const double clearance = passing_clearance(radius_);
    if (sees_point_after(clearance)) {
      take_next(true);
    } else if (sees(route_.points[route_.next + 1], clearance) ||
               (heading_point(route_, here_) - here_).norm() <= kOnWaypoint) {
      take_next(false);
    }
  }

  /// Skips waypoints that need not be visited.
  void look_ahead() {
    const double clearance = std::min(radius_ + kPullMargin, kWayClearance);
    while (!route_.on_last() && sees_point_after(clearance)) take_next(true);
  }

  /// On the last leg, finds out whether the nearest point of the destination can be headed for.
  /// Pushed to where a wall hides what it heads for, a person plans from there.
  void check_sight() {
    if (route_.on_last()) {
      route_.last_in_view =
          sees(nearest_on(route_.aim_a, route_.aim_b, here_), passing_clearance(radius_));
      if (route_.last_in_view) return;
    }
    if (!route_.found || crowd_.clock.substep - walker_.planned < kPlanEvery) return;
    if (!sees(heading_point(route_, here_), 0.0)) plan_again();
  }

  void plan_again() {
    const double beyond = route_.beyond;
    plan(crowd_.zone, here_, radius_, route_.destination, route_);
    route_.beyond = beyond;
    go_on_to(route_, route_.next);
    walker_.planned = crowd_.clock.substep;
    walker_.entered = false;
  }

  /// Blocked for the whole of its patience, a person goes on to the next waypoint when there is a
  /// free way to it, and plans again when there is not (the next one may be behind a corner). Near
  /// its destination it has arrived; far from it it goes on trying. A waypoint of the user's is
  /// passed over, however far it is. Waiting for a vehicle or the group, going with an adult or
  /// round a vehicle, chatting and sitting is not being blocked.
  void lose_patience(double dt) {
    const double left = way_left(route_, here_);
    if (left < walker_.least_left - kProgress) {
      walker_.least_left = left;
      walker_.blocked = 0.0;
    } else if (!stays()) {
      walker_.blocked += dt;
    }
    if (walker_.blocked < patience(crowd_.zone, walker_)) return;
    if (crowd_.paths[walker_.handle] != nullptr) {
      leave_waypoint(crowd_, row_, ways_);
      return;
    }
    walker_.least_left = left;
    walker_.blocked = 0.0;
    if (left <= kGiveUpWithin) {
      walker_.arrived = walker_.gave_up = true;
    } else if (!route_.on_last() && sees_point_after(passing_clearance(radius_))) {
      take_next(true);
    } else {
      plan_again();
    }
  }

  /// For a reason that is not being blocked.
  bool stays() const {
    return walker_.waits || crowd_.groups[walker_.handle].waits ||
           crowd_.children[walker_.handle].led ||
           crowd_.proposals.best(row_).by == Behaviour::kRound ||
           info_of(crowd_.activities[walker_.handle].activity).speed <= 0.0;
  }

  const CrowdState& crowd_;
  std::size_t row_;
  Ways ways_;
  const WallIndex& walls_;
  WalkState& walker_;
  Route& route_;
  Vec2 here_;
  double radius_;
  std::uint64_t turn_;  ///< spreads the looks of different persons over the substeps
  std::uint64_t substeps_;
};

}  // namespace

void follow_waypoints(const CrowdState& crowd, double dt, std::uint64_t substeps, Ways ways) {
  Persons& persons = ways.persons;
  for_each_block(persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      WalkState& walker = ways.walkers[i];
      const Vec2 from(crowd.moves.x[i], crowd.moves.y[i]), to = crowd.position(i);
      walker.standing = (to - from).norm() < kHaltingSpeed * dt ? walker.standing + dt : 0.0;
      if (!walker.arrived && !crowd.is_over(i)) {
        const StreetCrossing* const crossing = crowd.crossing(i);
        const bool to_kerb = crossing != nullptr && crossing->phase == CrossingPhase::kToKerb;
        const PathMemory& path = crowd.paths[walker.handle];
        if (path != nullptr && comes_by(crowd.zone.walls, path->current(), from, to)) {
          leave_waypoint(crowd, i, ways);
        } else if (to_kerb && reaches(walker.route, persons.radius[i], from, to)) {
          come_to_kerb(ways.crossing(i));
        } else if (!to_kerb && path == nullptr &&
                   reaches(walker.route, persons.radius[i], from, to)) {
          walker.arrived = true;
        } else {
          Follower(crowd, i, substeps, ways).follow(dt);
        }
      }
      if (walker.arrived && !crowd.decisions[i].escapes) persons.vx[i] = persons.vy[i] = 0.0;
    }
  });
}

}  // namespace pedzone
