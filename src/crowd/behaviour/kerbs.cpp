#include "crowd/behaviour/kerbs.hpp"

#include <algorithm>
#include <map>

#include "crowd/behaviour/crossing_plan.hpp"
#include "crowd/behaviour/gaps.hpp"
#include "crowd/sense/crosswalk_traffic.hpp"
#include "geometry/segment.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kAtHand = 2.0;    // [m] assumed: who waits at a kerb steps to and fro so far
constexpr double kAsks = 1.5;      // [m] assumed: so near the kerb it is seen to want to cross
constexpr double kBefore = 0.6;    // [m] assumed: it stands so far from the kerb
constexpr double kStops = 1.0;     // [s] assumed: in which it comes to stand there
constexpr double kAside = 0.5;     // [m] numerical: between lines that are tried
constexpr double kClosed = 120.0;  // [s] assumed: longer than a queue stands before a red light

/// That row i is on or comes to: by where its way leads beyond the corners at hand.
std::optional<CrosswalkAhead> crosswalk_ahead(const CrowdState& crowd, std::size_t i,
                                              double reach) {
  const Route& route = crowd.walkers[i].route;
  const Vec2 here = crowd.position(i);
  for (std::size_t k = route.next; k + 1 < route.points.size(); ++k) {
    if ((route.points[k] - here).norm() < kAtHand) continue;
    return crowd.zone.crosswalks.ahead(here, route.points[k], reach);
  }
  return crowd.zone.crosswalks.ahead(here, nearest_on(route.aim_a, route.aim_b, here), reach);
}

/// Whether it comes to that one, and has no priority there.
bool is_kerb(const std::optional<CrosswalkAhead>& ahead) {
  return ahead && !ahead->crosswalk.priority && ahead->gone <= 0.0;
}

/// Whether vehicles that do not give way are coming.
bool has_to_wait(const CrowdState& crowd, std::size_t i) {
  return crowd.kerbs[crowd.handle(i)].room != std::numeric_limits<double>::infinity();
}

/// Straight across.
CrossingWalk walk_over(const CrowdState& crowd, std::size_t i, const CrosswalkAhead& kerb,
                       double waited) {
  const Vec2 line = kerb.crosswalk.end - kerb.crosswalk.begin;
  CrossingWalk walk = walk_after(crowd, i, waited);
  walk.s = (crowd.position(i) - kerb.crosswalk.begin).dot(left_of(line.normalized()));
  walk.from = kerb.gone;
  walk.to = line.norm();
  walk.radius = crowd.persons.turned_radius[i];
  if (is_walking(crowd, i)) walk.start_up = 0.0;
  return walk;
}

/// Whether there is a gap, on its own line or, past vehicles that stand on that, on another one.
bool is_free(const CrowdState& crowd, std::span<const StreetVehicle> traffic, CrossingWalk walk,
             double width) {
  const GapView own = look_at_gap(traffic, crowd.vehicles, walk);
  if (own.enough || !own.barred) return own.enough;
  const double side = 0.5 * width - walk.radius;
  for (walk.s = -side; walk.s <= side; walk.s += kAside) {
    if (look_at_gap(traffic, crowd.vehicles, walk).enough) return true;
  }
  return false;
}

}  // namespace

bool comes_to_kerb(const CrowdState& crowd, std::size_t i, double way) {
  return !crowd.zone.crosswalks.empty() && is_kerb(crosswalk_ahead(crowd, i, kAsks + way));
}

std::optional<Crosswalk> crosswalk_used(const CrowdState& crowd, std::size_t i) {
  if (crowd.zone.crosswalks.empty()) return std::nullopt;
  const auto ahead = crosswalk_ahead(crowd, i, kAsks);
  if (!ahead || (is_kerb(ahead) && has_to_wait(crowd, i))) return std::nullopt;
  return ahead->crosswalk;
}

void look_at_kerbs(const CrowdState& crowd, double dt, ByHandle<KerbMemory>& kerbs) {
  if (crowd.zone.crosswalks.empty() || !crowd.model->minds_vehicles()) return;
  std::map<std::size_t, std::vector<StreetVehicle>> traffic;  // by kerb, looked for once
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    KerbMemory& memory = kerbs[crowd.handle(i)];
    memory.room = std::numeric_limits<double>::infinity();
    const auto kerb = crosswalk_ahead(crowd, i, kAsks);
    // Among others who wait it is moved to and fro, and beside the crossing: it still waits.
    if (kerb && !is_kerb(kerb)) memory.waited = 0.0;
    if (!kerb) memory.waited = std::max(0.0, memory.waited - dt);
    if (!is_kerb(kerb) || !crowd.traffic[crowd.handle(i)].aware) continue;
    if (memory.waited > kClosed) continue;
    // At a small junction crossings lie across each other: nobody waits for one on another.
    if (crowd.zone.crosswalks.covers(crowd.position(i))) continue;
    const CrossingWalk walk = walk_over(crowd, i, *kerb, memory.waited);
    const auto [coming, is_new] = traffic.try_emplace(kerb->kerb);
    if (is_new) coming->second = coming_over(kerb->crosswalk, crowd.vehicles);
    if (is_free(crowd, coming->second, walk, kerb->crosswalk.width)) continue;
    memory.room = std::max(0.0, -kerb->gone - kBefore);
    if (crowd.velocity(i).norm() < kHaltingSpeed) memory.waited += dt;
  }
}

void restrain_at_kerbs(const CrowdState& crowd, Restraints& restraints) {
  if (crowd.zone.crosswalks.empty()) return;
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    if (!has_to_wait(crowd, i)) continue;
    const double room = crowd.kerbs[crowd.handle(i)].room;
    restraints.limit(i, room / kStops);
    if (room / kStops < kHaltingSpeed) restraints.wait(i);
  }
}

}  // namespace pedzone
