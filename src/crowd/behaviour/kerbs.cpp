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
constexpr double kFarthest = 3.0;  // [m] numerical: that is looked for
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

/// That it comes to, where it has no priority.
std::optional<CrosswalkAhead> kerb_ahead(const CrowdState& crowd, std::size_t i, double reach) {
  const auto ahead = crosswalk_ahead(crowd, i, reach);
  if (!ahead || ahead->crosswalk.priority || ahead->gone > 0.0) return std::nullopt;
  return ahead;
}

/// Straight across.
CrossingWalk walk_over(const CrowdState& crowd, std::size_t i, const CrosswalkAhead& kerb,
                       double waited) {
  const Vec2 line = kerb.crosswalk.end - kerb.crosswalk.begin;
  const Parameters& parameters = crowd.zone.parameters;
  CrossingWalk walk;
  walk.s = (crowd.position(i) - kerb.crosswalk.begin).dot(left_of(line.normalized()));
  walk.from = kerb.gone;
  walk.to = line.norm();
  walk.radius = crowd.persons.turned_radius[i];
  walk.speed = crowd.persons.preferred_speed[i];
  const bool walks = crowd.velocity(i).norm() > 0.5 * walk.speed;
  walk.start_up = walks ? 0.0 : parameters.crossing_start_up;
  walk.margin = crossing_margin(crowd, i, waited);
  walk.insists = waited >= parameters.crossing_insists;
  return walk;
}

/// Whether there is a gap, on its own line or, past vehicles that stand on that, on another one.
bool is_free(const CrowdState& crowd, std::span<const StreetVehicle> traffic, CrossingWalk walk,
             double width) {
  const auto sees = [](std::uint32_t) { return true; };
  const GapView own = look_at_gap(traffic, crowd.vehicles, walk, sees);
  if (own.enough || !own.barred) return own.enough;
  const double side = 0.5 * width - walk.radius;
  for (walk.s = -side; walk.s <= side; walk.s += kAside) {
    if (look_at_gap(traffic, crowd.vehicles, walk, sees).enough) return true;
  }
  return false;
}

/// Vehicles that come over crosswalks, each looked for once.
class Traffic {
 public:
  explicit Traffic(const CrowdState& crowd) : crowd_(crowd) {}

  /// As seen by who comes to it.
  std::span<const StreetVehicle> over(const CrosswalkAhead& kerb) {
    const bool turned = kerb.crosswalk.begin != crowd_.zone.crosswalks[kerb.index].begin;
    const auto [found, is_new] = known_.try_emplace(std::pair{kerb.index, turned});
    if (is_new) found->second = coming_over(kerb.crosswalk, crowd_.vehicles);
    return found->second;
  }

 private:
  const CrowdState& crowd_;
  std::map<std::pair<std::size_t, bool>, std::vector<StreetVehicle>> known_;
};

}  // namespace

bool comes_to_kerb(const CrowdState& crowd, std::size_t i, double way) {
  const double reach = std::min(kAsks + way, kFarthest);
  return !crowd.zone.crosswalks.empty() && kerb_ahead(crowd, i, reach).has_value();
}

std::optional<Crosswalk> zebra_used(const CrowdState& crowd, std::size_t i) {
  if (crowd.zone.crosswalks.empty()) return std::nullopt;
  const auto ahead = crosswalk_ahead(crowd, i, kAsks);
  if (!ahead || !ahead->crosswalk.priority) return std::nullopt;
  return ahead->crosswalk;
}

void look_at_kerbs(const CrowdState& crowd, double dt, ByHandle<KerbMemory>& kerbs) {
  if (crowd.zone.crosswalks.empty() || !crowd.model->minds_vehicles()) return;
  Traffic traffic(crowd);
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    KerbMemory& memory = kerbs[crowd.handle(i)];
    memory.room = std::numeric_limits<double>::infinity();
    const auto kerb = kerb_ahead(crowd, i, kAsks);
    if (!kerb) memory.waited = 0.0;
    if (!kerb || !crowd.traffic[crowd.handle(i)].aware) continue;
    if (memory.waited > kClosed) continue;
    const CrossingWalk walk = walk_over(crowd, i, *kerb, memory.waited);
    if (is_free(crowd, traffic.over(*kerb), walk, kerb->crosswalk.width)) continue;
    memory.room = std::max(0.0, -kerb->gone - kBefore);
    if (crowd.velocity(i).norm() < kHaltingSpeed) memory.waited += dt;
  }
}

void restrain_at_kerbs(const CrowdState& crowd, Restraints& restraints) {
  if (crowd.zone.crosswalks.empty()) return;
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    const double room = crowd.kerbs[crowd.handle(i)].room;
    if (room == std::numeric_limits<double>::infinity()) continue;
    restraints.limit(i, room / kStops);
    if (room / kStops < kHaltingSpeed) restraints.wait(i);
  }
}

}  // namespace pedzone
