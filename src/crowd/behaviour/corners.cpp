#include "crowd/behaviour/corners.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone {
namespace {

constexpr double kApproach = 8.0;  // [m] assumed: nearer than this a corner is looked at
constexpr double kAround = 6.0;    // [m] assumed: people so near the corner count
constexpr double kWidest = 6.0;    // [m] assumed: a wider turn is a detour
constexpr double kApart = 1.7;     // assumed: left to those who come, at least, over one's body
constexpr double kPlace = 0.25;    // [m] numerical: between places that are tried
constexpr double kLane = 1.2;      // assumed: width that somebody needs, over its body's
constexpr double kStuckAfter = 1.0, kStuckRate = 0.5;  // [s], [m/s] assumed: who is stuck for
                                                       // longer takes it wider and wider

/// A corner as somebody comes to it: unit vectors of the way through and to the outside.
struct Bend {
  Vec2 corner, after, through, outside;
  bool leftward;
};

/// False where the way does not turn.
bool bend_before(const Route& route, const Vec2& here, Bend& bend) {
  bend.corner = route.points[route.next];
  bend.after = route.points[route.next + 1];
  if ((bend.corner - here).norm() > kApproach) return false;
  const Vec2 before = route.next > 0 ? route.points[route.next - 1] : route.start;
  const Vec2 in = bend.corner - before, out = bend.after - bend.corner;
  if (in.isZero() || out.isZero()) return false;
  const Vec2 e_in = in.normalized(), e_out = out.normalized();
  bend.leftward = cross(e_in, e_out) > 0.0;
  const Vec2 through = e_in + e_out;
  if (through.norm() < 1e-3) return false;  // straight back
  bend.through = through.normalized();
  bend.outside = bend.leftward ? Vec2(-left_of(bend.through)) : left_of(bend.through);
  return true;
}

/// [m] width that those near the corner need, by the way they go.
struct Needs {
  double along = 0.0, opposed = 0.0;
};

Needs needs_at(const CrowdState& crowd, std::size_t i, const Bend& bend) {
  Needs needs;
  const Vec2 box = Vec2::Constant(kAround);
  crowd.grid.visit_box(bend.corner - box, bend.corner + box, [&](std::uint32_t j, const Vec2& at) {
    if (j == i || (at - bend.corner).squaredNorm() > kAround * kAround) return;
    const bool opposed = unit(crowd.persons.heading[j]).dot(bend.through) < 0.0;
    // Numbers of few digits: their sum does not depend on the order in which people are found.
    const auto radius = static_cast<float>(crowd.persons.turned_radius[j]);
    (opposed ? needs.opposed : needs.along) += static_cast<double>(radius);
  });
  needs.along *= 2.0 * kLane;
  needs.opposed *= 2.0 * kLane;
  return needs;
}

/// [m] free to the outside of the corner, in steps of kPlace.
double room_outside(const CrowdState& crowd, const Bend& bend, double wanted) {
  double room = 0.0;
  while (room < wanted) {
    const Vec2 place = bend.corner + (room + kPlace) * bend.outside;
    if (!crowd.zone.walls.free_line(bend.corner, place) ||
        !crowd.zone.walls.free_line(place, bend.after)) {
      break;
    }
    room += kPlace;
  }
  return room;
}

/// [m] from the corner to where somebody who walks on as it faces passes it; beyond `most` where it
/// does not.
double straight_on(const CrowdState& crowd, std::size_t i, const Bend& bend, double most) {
  const Vec2 e = unit(crowd.persons.heading[i]), from = crowd.position(i) - bend.corner;
  const double across = cross(e, bend.outside);
  if (std::abs(across) < 1e-3) return most;
  return cross(e, from) / across;
}

}  // namespace

Vec2 beside_corner(const CrowdState& crowd, std::size_t i) {
  Bend bend;
  const Vec2 here = crowd.position(i);
  if (!bend_before(crowd.walkers[i].route, here, bend)) return Vec2::Zero();
  if ((here - bend.corner).dot(bend.through) > 0.0) return Vec2::Zero();
  const Needs needs = needs_at(crowd, i, bend);
  const double stuck =
      std::max(0.0, (crowd.jams[crowd.handle(i)].stuck - kStuckAfter) * kStuckRate);
  const double apart =
      needs.opposed > 0.0 ? std::max(needs.opposed, 2.0 * kApart * crowd.persons.radius[i]) : 0.0;
  const double wanted = std::min(needs.along + apart + stuck, kWidest);
  if (wanted == 0.0) return Vec2::Zero();
  const double room = room_outside(crowd, bend, wanted);
  const double all = needs.along + apart;
  const double scale = all > room ? room / all : 1.0;
  const double first = bend.leftward ? apart * scale : 0.0;
  const double last = std::min(room, first + needs.along * scale + stuck);
  const double clearance = passing_clearance(crowd.persons.radius[i]);
  for (double at = std::clamp(straight_on(crowd, i, bend, last), first, last); at > kPlace;
       at *= 0.5) {
    const Vec2 place = bend.corner + at * bend.outside;
    if (crowd.zone.walls.free_line(here, place, clearance)) return at * bend.outside;
  }
  return Vec2::Zero();
}

}  // namespace pedzone
