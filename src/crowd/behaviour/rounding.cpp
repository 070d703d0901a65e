// Direction heuristics weigh a way by how much nearer it leads. Along the bumper of a vehicle that
// stands none does: those in front of its middle turned left and right for as long as it stood,
// while others walked past at its sides.
#include "crowd/behaviour/rounding.hpp"

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "crowd/sense/side_room.hpp"
#include "crowd/sense/vehicle_motion.hpp"
#include "crowd/state/parallel.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kInVain = 2.0;   // [s] assumed: gets no further for so long
constexpr double kAhead = 1.5;    // [m] assumed: so near a vehicle is what keeps it
constexpr double kRoom = 0.05;    // [m] assumed: left between its body and the vehicle
constexpr double kReached = 0.1;  // [m] assumed: so near a corner it goes on to the next one
constexpr double kPast = 0.5;     // [m] assumed: it looks so far beyond the corner
constexpr double kTouch = 0.02;   // [m] numerical: of bodies that touch
constexpr double kGrazing = 0.8;  // numerical: share of the turned body that must pass
const std::array<Vec2, 4> kCorners{Vec2(1, 1), Vec2(1, -1), Vec2(-1, 1), Vec2(-1, -1)};

Rectangle grown(Rectangle body, double by) {
  body.half += Vec2::Constant(by);
  return body;
}

bool stands(const VehicleState& vehicle) {
  return may_be_passed(vehicle) && vehicle.velocity.norm() < kStaticSpeed;
}

/// The vehicle that stands in its way, or the part of one; null: none. One that claims room sends
/// people off itself.
const VehicleState* barring(const CrowdState& crowd, std::size_t i, const Wish& wish) {
  const Vec2 here = crowd.position(i);
  const double radius = crowd.persons.present_radius[i];
  const Vec2 there = here + unit(wish.direction) * std::min(wish.distance, radius + kAhead);
  const VehicleState* found = nullptr;
  double nearest = 0.0;
  for (const std::uint32_t v : crowd.vehicles_near.at(here, radius + kAhead)) {
    const VehicleState& vehicle = crowd.vehicles[v];
    if (!stands(vehicle) || vehicle.claim > 0.0) continue;
    const Rectangle& body = crowd.vehicle_bodies[v];
    const double distance = body.distance(here);
    if (found != nullptr && distance >= nearest) continue;
    if (!runs_through(grown(body, radius - kTouch), here, there)) continue;
    found = &vehicle;
    nearest = distance;
  }
  return found;
}

/// Bodies that nobody gets between, each grown by what a person needs beside it.
using Row = boost::container::small_vector<Rectangle, 4>;

bool overlap(const Rectangle& a, const Rectangle& b) {
  return std::ranges::any_of(kCorners, [&](const Vec2& sides) {
    return a.distance(b.out_of_frame(b.half.cwiseProduct(sides))) <= 0.0 ||
           b.distance(a.out_of_frame(a.half.cwiseProduct(sides))) <= 0.0;
  });
}

/// The vehicle, its other parts, and others that stand so close that nobody gets between.
Row row_of(const CrowdState& crowd, std::size_t i, const VehicleState& vehicle) {
  const double room = crowd.persons.turned_radius[i] + kRoom;
  Row row{grown(rectangle_of(vehicle), room)};
  const auto near = crowd.vehicles_near.at(crowd.position(i));
  std::vector<bool> taken(near.size(), false);
  for (bool more = true; more;) {
    more = false;
    for (std::size_t k = 0; k < near.size(); ++k) {
      const VehicleState& other = crowd.vehicles[near[k]];
      if (taken[k] || &other == &vehicle || !stands(other)) continue;
      const Rectangle body = grown(crowd.vehicle_bodies[near[k]], room);
      const auto touches = [&](const Rectangle& one) { return overlap(one, body); };
      if (other.key != vehicle.key && std::ranges::none_of(row, touches)) continue;
      row.push_back(body);
      taken[k] = more = true;
    }
  }
  const double rest = crowd.persons.present_radius[i] - crowd.persons.turned_radius[i];
  for (Rectangle& body : row) body = grown(body, rest);
  return row;
}

/// Where it sees a body from that it touches: from its side.
Vec2 outside_of(const Rectangle& body, const Vec2& from) {
  Vec2 at = body.into_frame(from);
  const Vec2 depth = body.half - at.cwiseAbs();
  if (depth.minCoeff() <= 0.0) return from;
  const int side = depth.x() < depth.y() ? 0 : 1;
  at[side] = std::copysign(body.half[side], at[side]);
  return body.out_of_frame(at);
}

/// The corners of all parts that bound them to the left and to the right, as seen from there
/// towards `middle` [m].
std::array<Vec2, 2> outline(std::span<const Rectangle> parts, const Vec2& from,
                            const Vec2& middle) {
  std::array<Vec2, 2> found{from, from};
  const double towards = angle_of(middle - from);
  double left = 0.0, right = 0.0;
  for (const Rectangle& part : parts) {
    for (const Vec2& sides : kCorners) {
      const Vec2 corner = part.out_of_frame(part.half.cwiseProduct(sides));
      if ((corner - from).norm() < kReached) continue;
      const double angle = wrap_angle(angle_of(corner - from) - towards);
      if (angle > left) found[0] = corner;
      if (angle < right) found[1] = corner;
      left = std::max(left, angle);
      right = std::min(right, angle);
    }
  }
  return found;
}

/// Whether it has to go round more of the row on that way.
bool bars(const Row& row, const Vec2& from, const Vec2& to) {
  return std::ranges::any_of(
      row, [&](const Rectangle& body) { return runs_through(grown(body, -kTouch), from, to); });
}

/// Whether walls leave a way to there.
bool is_free(const CrowdState& crowd, std::size_t i, const Vec2& there) {
  const double half = kGrazing * crowd.persons.turned_radius[i];
  return crowd.zone.walls.free_line(crowd.position(i), there, half);
}

/// The corner [m] by which it goes round that vehicle.
std::optional<Vec2> corner_round(const CrowdState& crowd, std::size_t i, const Wish& wish,
                                 const VehicleState& vehicle) {
  const Vec2 here = crowd.position(i), end = here + unit(wish.direction) * wish.distance;
  const Row row = row_of(crowd, i, vehicle);
  Vec2 eye = here;
  for (const Rectangle& body : row) eye = outside_of(body, eye);
  std::optional<Vec2> best;
  double shortest = 0.0;
  for (const Vec2& corner : outline({row.data(), row.size()}, eye, row.front().centre)) {
    const double on = bars(row, corner, end) ? 2.0 * row.front().half.maxCoeff() : 0.0;
    const double way = (corner - here).norm() + (end - corner).norm() + on;
    if ((best && way >= shortest) || !is_free(crowd, i, corner)) continue;
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
      const VehicleState* const vehicle = barring(crowd, i, wish);
      if (vehicle == nullptr) continue;
      const auto corner = corner_round(crowd, i, wish, *vehicle);
      if (!corner) continue;
      const Vec2 there = *corner - crowd.position(i);
      proposals.propose(i, {angle_of(there), there.norm() + kPast, Behaviour::kRound});
    }
  });
}

}  // namespace pedzone
