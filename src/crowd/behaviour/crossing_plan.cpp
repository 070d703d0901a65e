#include "crowd/behaviour/crossing_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "crowd/behaviour/families.hpp"

namespace pedzone {
namespace {

constexpr double kWorthWhile = 5.0;  // [m] assumed: nobody crosses elsewhere for less
constexpr double kKerb = 0.2;        // [m] assumed: who waits keeps so far from the carriageway
constexpr double kLater = 1e-3;      // numerical: of equal places, the one nearest to the end
constexpr std::size_t kWeighed = 3;  // numerical: so many streets are weighed by real ways
constexpr double kFarShare = 0.75;   // of the width that a gap must last for, in the mean of a near
                                     // and a far lane
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A street that might be crossed.
struct Candidate {
  std::uint32_t street = 0;
  int side = 1;
  double s = 0.0;
  double least = kInfinity;  ///< [m] no way over it is shorter
};

double kerb_of(const CrossingPlace& place, int side) { return side > 0 ? place.low : place.high; }

Vec2 before(const Street& street, double s, int side, double radius) {
  return street.point(s, kerb_of(street.at(s), side) - side * (radius + kKerb));
}

Vec2 beyond(const Street& street, double s, int side, double radius) {
  return street.point(s, kerb_of(street.at(s), -side) + side * (radius + kKerb));
}

/// A child in no group does not cross alone where it has another way.
bool goes_alone_as_child(const CrowdState& crowd, std::size_t i) {
  return goes_with_adult(crowd.walkers[i].profile) && crowd.groups[crowd.handle(i)].group == 0;
}

/// The best place of a street as the crow flies.
Candidate best_place(const Street& street, std::uint32_t index, int side, const Vec2& from,
                     const Vec2& to, double radius, bool impulsive) {
  Candidate best{index, side};
  double least = kInfinity;
  const double end = street.place(to).s;
  for (std::size_t k = 0; k < street.places.size(); ++k) {
    const CrossingPlace& place = street.places[k];
    if (!place.open_to(impulsive)) continue;
    const double s = static_cast<double>(k) * kStreetStep;
    const double length = (before(street, s, side, radius) - from).norm() + place.width() +
                          (to - beyond(street, s, side, radius)).norm();
    const double cost = length + kLater * std::abs(end - s);
    if (cost >= least) continue;
    least = cost;
    best.s = s;
    best.least = length;
  }
  return best;
}

/// Streets by which `most` [m] would not be reached, the shortest first.
std::vector<Candidate> candidates(const CrowdState& crowd, std::size_t i, const Vec2& to,
                                  double most) {
  std::vector<Candidate> found;
  const std::vector<Street>& streets = crowd.zone.streets;
  const bool impulsive = is_impulsive(crowd, i);
  for (std::uint32_t k = 0; k < streets.size(); ++k) {
    for (const int side : {1, -1}) {
      const Candidate best = best_place(streets[k], k, side, crowd.position(i), to,
                                        crowd.persons.radius[i], impulsive);
      if (best.least < most - kWorthWhile) found.push_back(best);
    }
  }
  std::ranges::stable_sort(found, {}, &Candidate::least);
  if (found.size() > kWeighed) found.resize(kWeighed);
  return found;
}

/// The ways to a street and from it on [m].
struct Legs {
  double to_kerb, on;
};

Legs legs_over(const CrowdState& crowd, std::size_t i, const Candidate& candidate, const Vec2& to) {
  const Street& street = crowd.zone.streets[candidate.street];
  const double radius = crowd.persons.radius[i];
  const Vec2 kerb = before(street, candidate.s, candidate.side, radius);
  const Vec2 far = beyond(street, candidate.s, candidate.side, radius);
  return {crowd.zone.ways.distance(crowd.position(i), kerb), crowd.zone.ways.distance(far, to)};
}

/// t of the next refuge on the way, or of the far kerb.
double next_stop(const Street& street, double from, double kerb, int side) {
  double stop = kerb;
  for (const double refuge : street.refuges) {
    if (side * (refuge - from) > 0.5 * kRefuge && side * (stop - refuge) > 0.0) stop = refuge;
  }
  return stop;
}

void head_for_kerb(const CrowdState& crowd, std::size_t i, Route& route) {
  const StreetCrossing& crossing = *crowd.crossing(i);
  const Vec2 kerb = kerb_before(crowd, i, crossing.at);
  plan(crowd.zone, crowd.position(i), crowd.persons.radius[i], {kerb, kerb}, route);
  route.beyond = crowd.zone.streets[crossing.street].at(crossing.at).width() + crossing.beyond;
  go_on_to(route, route.next);
}

/// The crossing that makes the way shortest, by 5 m or more; null: none. `length` [m]: of the best
/// way without one, then with it.
std::unique_ptr<StreetCrossing> best_crossing(const CrowdState& crowd, std::size_t i,
                                              const Vec2& to, double& length) {
  std::unique_ptr<StreetCrossing> best;
  for (const Candidate& candidate : candidates(crowd, i, to, length)) {
    if (candidate.least >= length - kWorthWhile) break;
    const Legs legs = legs_over(crowd, i, candidate, to);
    const double width = crowd.zone.streets[candidate.street].at(candidate.s).width();
    const double over = legs.to_kerb + width + legs.on;
    if (!std::isfinite(over) || over > length - kWorthWhile) continue;
    length = over;
    best = std::make_unique<StreetCrossing>();
    best->street = candidate.street;
    best->side = candidate.side;
    best->at = candidate.s;
    best->beyond = legs.on;
  }
  return best;
}

/// [s] that it takes row i beside the way: the wait to be expected, and its aversion.
double cost_of_crossing(const CrowdState& crowd, std::size_t i, const StreetCrossing& crossing) {
  const double width = crowd.zone.streets[crossing.street].at(crossing.at).width();
  const bool known = crossing.street < crowd.street_traffic.size();
  const double flow = known ? crowd.street_traffic[crossing.street].flow : 0.0;
  const CrossingWalk walk = walk_across(crowd, i, crossing.at);
  const double needed = kFarShare * width / walk.speed + walk.start_up + walk.margin;
  return expected_wait(flow, needed) + crowd.zone.parameters.crossing_aversion;
}

}  // namespace

bool is_impulsive(const CrowdState& crowd, std::size_t i) {
  const Profile* profile = crowd.walkers[i].profile;
  return profile != nullptr && profile->impulsiveness > 0.0;
}

Vec2 kerb_before(const CrowdState& crowd, std::size_t i, double s) {
  const StreetCrossing& crossing = *crowd.crossing(i);
  return before(crowd.zone.streets[crossing.street], s, crossing.side, crowd.persons.radius[i]);
}

Vec2 kerb_beyond(const CrowdState& crowd, std::size_t i, double s) {
  const StreetCrossing& crossing = *crowd.crossing(i);
  return beyond(crowd.zone.streets[crossing.street], s, crossing.side, crowd.persons.radius[i]);
}

CrossingWalk walk_after(const CrowdState& crowd, std::size_t i, double waited) {
  const Parameters& parameters = crowd.zone.parameters;
  const Profile* profile = crowd.walkers[i].profile;
  CrossingWalk walk;
  walk.radius = crowd.persons.radius[i];
  walk.speed = crowd.persons.preferred_speed[i];
  walk.start_up = parameters.crossing_start_up;
  const double worn = std::min(1.0, waited / parameters.crossing_margin_time);
  const double least = std::min(parameters.crossing_margin, parameters.crossing_margin_least);
  walk.margin = std::lerp(parameters.crossing_margin, least, worn) *
                (profile != nullptr ? profile->caution : 1.0);
  walk.insists = waited >= parameters.crossing_insists;
  return walk;
}

bool is_walking(const CrowdState& crowd, std::size_t i) {
  return crowd.persons.preferred_speed[i] * 0.5 < crowd.velocity(i).norm();
}

CrossingWalk walk_across(const CrowdState& crowd, std::size_t i, double s) {
  const StreetCrossing& crossing = *crowd.crossing(i);
  const Street& street = crowd.zone.streets[crossing.street];
  CrossingWalk walk = walk_after(crowd, i, crossing.waited);
  walk.s = s;
  walk.from = street.place(crowd.position(i)).t;
  walk.to = next_stop(street, walk.from, kerb_of(street.at(s), -crossing.side), crossing.side);
  return walk;
}

void plan_crossing(const CrowdState& crowd, std::size_t i, const Destination& destination,
                   Ways ways) {
  if (crowd.zone.streets.empty()) return;
  CrossingMemory& memory = ways.crossings[crowd.handle(i)];
  memory.now.reset();
  Route& route = ways.walkers[i].route;
  const Vec2 here = crowd.position(i), to = 0.5 * (route.aim_a + route.aim_b);
  const double by_nodes = route.found ? way_left(route, here) : memory.by_junctions;
  // Who can get there neither inside the zone nor over a street would stand in it for ever.
  memory.stays_outside = !route.found && std::isfinite(by_nodes);
  if (by_nodes - (to - here).norm() < kWorthWhile) return;
  if (goes_alone_as_child(crowd, i) && std::isfinite(by_nodes)) return;
  double length = by_nodes;
  memory.now = best_crossing(crowd, i, to, length);
  if (memory.now == nullptr) return;
  StreetCrossing& crossing = *memory.now;
  crossing.destination = destination;
  const double speed = crowd.persons.preferred_speed[i];
  const bool slower = length / speed + cost_of_crossing(crowd, i, crossing) >= by_nodes / speed;
  memory.stays_outside = !route.found && slower;
  if (route.found && slower) return;  // by the junctions, unless a gap comes
  // Once it is the crowd's there is no way by junctions outside the zone.
  crossing.detour = route.found ? (by_nodes - length) / speed : kInfinity;
  crossing.phase = CrossingPhase::kToKerb;
  head_for_kerb(crowd, i, route);
}

void go_by_nodes(const CrowdState& crowd, std::size_t i, Ways ways) {
  StreetCrossing& crossing = ways.crossing(i);
  crossing.phase = CrossingPhase::kByNodes;
  crossing.at_kerb = false;
  WalkState& walker = ways.walkers[i];
  plan(crowd.zone, crowd.position(i), crowd.persons.radius[i], crossing.destination, walker.route);
  walker.planned = crowd.clock.substep;
  walker.entered = false;
  walker.start_clocks();
}

void head_across(const CrowdState& crowd, std::size_t i, double s, Route& route) {
  const StreetCrossing& crossing = *crowd.crossing(i);
  const Vec2 far = kerb_beyond(crowd, i, s);
  route.destination = {far, far};
  route.aim_a = route.aim_b = far;
  route.points.assign(1, far);
  route.start = crowd.position(i);
  route.found = route.last_in_view = true;
  route.beyond = std::abs(crossing.at - s) + crossing.beyond;
  go_on_to(route, 0);
}

void head_along(const CrowdState& crowd, std::size_t i, double s, Route& route) {
  head_across(crowd, i, s, route);
  const Street& street = crowd.zone.streets[crowd.crossing(i)->street];
  const double t = street.place(crowd.position(i)).t;
  route.points.insert(route.points.begin(), street.point(s, t));
  go_on_to(route, 0);
}

std::optional<CrossingLine> nearest_line(const CrowdState& crowd, std::size_t i, double s,
                                         double step, double farthest,
                                         const std::function<bool(double s)>& is_barred) {
  const Street& street = crowd.zone.streets[crowd.crossing(i)->street];
  const bool impulsive = is_impulsive(crowd, i);
  for (double way = step; way <= farthest; way += step) {
    for (const double other : {s - way, s + way}) {
      if (other < 0.0 || other > street.length || !street.at(other).open_to(impulsive)) continue;
      if (!is_barred(other)) return CrossingLine{other, way};
    }
  }
  return std::nullopt;
}

void move_along_kerb(const CrowdState& crowd, std::size_t i,
                     const std::function<bool(double s)>& is_barred, Ways ways) {
  StreetCrossing& crossing = ways.crossing(i);
  const double length = crowd.zone.streets[crossing.street].length;
  const auto line = nearest_line(crowd, i, crossing.at, kStreetStep, length, is_barred);
  if (!line) return;
  crossing.at = line->s;
  crossing.at_kerb = false;
  crossing.beyond += line->way;
  head_for_kerb(crowd, i, ways.walkers[i].route);
  ways.walkers[i].start_clocks();
}

}  // namespace pedzone
