// Direction heuristics weigh a way by how much nearer it leads. Along the bumper of a vehicle that
// stands none does: those in front of its middle turned left and right for as long as it stood,
// while others walked past at its sides.
#include "crowd/behaviour/rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "crowd/sense/side_room.hpp"
#include "crowd/state/parallel.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kInVain = 2.0;   // [s] assumed: gets no further for so long
constexpr double kAhead = 1.5;    // [m] assumed: so near a vehicle is what keeps it
constexpr double kRoom = 0.05;    // [m] assumed: left between its body and the vehicle
constexpr double kPast = 0.5;     // [m] assumed: it looks so far beyond the corner
constexpr double kTouch = 0.02;   // [m] numerical: of bodies that touch
constexpr double kGrazing = 0.8;  // numerical: share of the turned body that must pass

Rectangle grown(Rectangle body, double by) {
  body.half += Vec2::Constant(by);
  return body;
}

/// The vehicle that stands in its way; null: none. One that claims room sends people off itself.
const Rectangle* barring(const CrowdState& crowd, std::size_t i, const Wish& wish) {
  const Vec2 here = crowd.position(i);
  const double radius = crowd.persons.present_radius[i];
  const Vec2 there = here + unit(wish.direction) * std::min(wish.distance, radius + kAhead);
  for (const std::uint32_t v : crowd.vehicles_near.at(here, radius + kAhead)) {
    const VehicleState& vehicle = crowd.vehicles[v];
    if (vehicle.velocity.norm() >= kStaticSpeed || vehicle.claim > 0.0) continue;
    const Rectangle& body = crowd.vehicle_bodies[v];
    if (runs_through(grown(body, radius - kTouch), here, there)) return &body;
  }
  return nullptr;
}

/// Its two corners that bound it as seen from there: the left one, then the right one.
std::array<Vec2, 2> outline(const Rectangle& body, const Vec2& from) {
  // Who touches it sees it from its side.
  Vec2 at = body.into_frame(from);
  const Vec2 depth = body.half - at.cwiseAbs();
  if (depth.minCoeff() > 0.0) {
    const int side = depth.x() < depth.y() ? 0 : 1;
    at[side] = std::copysign(body.half[side], at[side]);
  }
  const Vec2 eye = body.out_of_frame(at);
  const double middle = angle_of(body.centre - eye);
  std::array<Vec2, 2> found{eye, eye};
  double left = 0.0, right = 0.0;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Vec2 corner = body.out_of_frame({x * body.half.x(), y * body.half.y()});
      const double angle = wrap_angle(angle_of(corner - eye) - middle);
      if (angle > left) found[0] = corner;
      if (angle < right) found[1] = corner;
      left = std::max(left, angle);
      right = std::min(right, angle);
    }
  }
  return found;
}

/// Whether walls and other vehicles leave a way to there.
bool is_free(const CrowdState& crowd, std::size_t i, const Rectangle& barring, const Vec2& there) {
  const Vec2 here = crowd.position(i);
  const double half = kGrazing * crowd.persons.turned_radius[i];
  if (!crowd.zone.walls.free_line(here, there, half)) return false;
  const auto near = crowd.vehicles_near.at(here, (there - here).norm() + half);
  return std::ranges::none_of(near, [&](std::uint32_t v) {
    return &crowd.vehicle_bodies[v] != &barring && may_be_passed(crowd.vehicles[v]) &&
           leads_through(crowd.vehicles[v], here, there, half);
  });
}

/// The corner [m] by which it goes round that vehicle.
std::optional<Vec2> corner_round(const CrowdState& crowd, std::size_t i, const Wish& wish,
                                 const Rectangle& body) {
  const Vec2 here = crowd.position(i), end = here + unit(wish.direction) * wish.distance;
  std::optional<Vec2> best;
  double shortest = 0.0;
  for (const Vec2& corner : outline(grown(body, crowd.persons.present_radius[i] + kRoom), here)) {
    const double way = (corner - here).norm() + (end - corner).norm();
    if ((best && way >= shortest) || !is_free(crowd, i, body, corner)) continue;
    best = corner;
    shortest = way;
  }
  return best;
}

}  // namespace

void propose_ways_round_vehicles(const CrowdState& crowd, Proposals& proposals) {
  if (crowd.vehicles.empty()) return;
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const WalkState& walker = crowd.walkers[i];
      if (walker.blocked < kInVain || walker.arrived || crowd.is_over(i)) continue;
      const Wish& wish = proposals.best(i);
      const Rectangle* const body = barring(crowd, i, wish);
      if (body == nullptr) continue;
      const auto corner = corner_round(crowd, i, wish, *body);
      if (!corner) continue;
      const Vec2 there = *corner - crowd.position(i);
      proposals.propose(i, {angle_of(there), there.norm() + kPast, Behaviour::kRound});
    }
  });
}

}  // namespace pedzone
