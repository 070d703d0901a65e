#include "sumo/plan/takeover_plan.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "core/random.hpp"
#include "sumo/plan/late_braking.hpp"
#include "sumo/plan/route_way.hpp"
#include "sumo/plan/yield_plan.hpp"
#include "zone/lane_geometry.hpp"
#include "zone/links.hpp"

namespace pedzone {
namespace {

constexpr double kWorthWhile = 1.5;   // [m] numerical: a shorter way to the portal stays SUMO's
constexpr double kBeforeEntry = 0.2;  // [m] numerical: so far before an edge's end
constexpr double kStray = 1.0;        // [m] numerical: SUMO's place may lie so far outside the area

/// The route index of `edge` after `last`; -1 when it is not there or there more than once, for
/// then SUMO does not tell which passage this is.
int only_index(const std::vector<int>& route, int edge, int last) {
  int index = -1;
  for (int i = last + 1; i < static_cast<int>(route.size()); ++i) {
    if (route[i] != edge) continue;
    if (index >= 0) return -1;
    index = i;
  }
  return index;
}

/// Lane distance [m] that is left to the end of the stretch on its last edge.
double left_on_last(const Network& network, const ZoneStretch& stretch, const Vec2& position) {
  const double at = project_on_lane(network.lanes[stretch.lane], position).offset;
  if (stretch.release != Release::kLeave) return std::abs(stretch.position - at);
  return stretch.forward ? stretch.position - at : at - stretch.position;
}

bool worth_while(const Network& network, const ZoneStretch& stretch, int index,
                 const Vec2& position) {
  return stretch.release == Release::kStepOver || stretch.last != index ||
         left_on_last(network, stretch, position) >= kWorthWhile;
}

/// Whether people get from one place to another over a street of the zone.
bool is_reachable_over_a_street(const Zone& zone, const Vec2& from, const Vec2& to) {
  constexpr double kStand = 0.5;  // [m] numerical: behind the kerb
  return std::ranges::any_of(zone.streets, [&](const Street& street) {
    const auto open = std::ranges::find_if(street.places, &CrossingPlace::open);
    const double s = kStreetStep * static_cast<double>(open - street.places.begin());
    const Vec2 low = street.point(s, open->low - kStand),
               high = street.point(s, open->high + kStand);
    return (zone.ways.has_way(from, low) && zone.ways.has_way(high, to)) ||
           (zone.ways.has_way(from, high) && zone.ways.has_way(low, to));
  });
}

/// The walk of a person on route[index]; nothing where pedzone cannot take it over.
/// `walked_until_now`: as of plan_takeover(); how much of the route it has behind it is not known
/// then.
std::optional<TakeoverPlan> plan_walk(const Network& network, const Zone& zone,
                                      const std::vector<int>& route, int index,
                                      const WalkerSeen& walker, bool walked_until_now) {
  const auto stretch = plan_stretch(network, zone, route, index, walker.arrival_position);
  if (!stretch) return std::nullopt;
  const Vec2 inside = zone.walls.nearest_inside(walker.position, 0.0);
  if ((inside - walker.position).norm() > kStray) return std::nullopt;
  const Vec2 goal = 0.5 * (stretch->destination.a + stretch->destination.b);
  TakeoverPlan plan{*stretch, inside};
  const RoutePart part{network, zone, route, index, stretch->last, inside, goal};
  const std::vector<Vec2> ends = ends_of_edges(part);
  if (zone.ways.has_way(inside, goal)) {
    if (!walked_until_now) plan.round = waypoints_of(part, ends);
  } else {
    if (!is_reachable_over_a_street(zone, inside, goal)) return std::nullopt;
    plan.by_junctions = length_by(part, ends);
  }
  return plan;
}

/// Whether SUMO may have the person beyond the end of route[index] within a step of `dt` [s], on
/// a walking area from which the route goes on with the next edge.
bool is_about_to_leave(const Network& network, const std::vector<int>& route, int index,
                       const WalkerSeen& walker, double dt) {
  const int edge = route[index], next = route[index + 1];
  const auto forward = leaves_forward(network, index > 0 ? route[index - 1] : -1, edge, next);
  if (!forward) return false;
  const Lane& lane = network.lanes[walking_lane(network, edge)];
  const double at = project_on_lane(lane, walker.position).offset;
  const double left = *forward ? lane.length - at : at;
  return left <= walker.speed * dt + kBeforeEntry && share_walking_area(network, edge, next);
}

/// What is remembered of another plan than its present one does not count.
void note_plan(const WalkerSeen& walker, PersonPast& past) {
  const std::size_t number = plan_number(walker.stages_left, walker.edges, walker.arrival_position);
  if (past.plan == number) return;
  past.plan = number;
  past.last = -1;
}

/// Whether some vehicle could not stop as it likes to for somebody who stands there from now on:
/// SUMO has put the person before it.
bool could_not_stop_for(const Fleet& fleet, const Vec2& position, double radius, double dt) {
  PersonAhead person;
  person.position = position;
  person.radius = radius;
  return std::ranges::any_of(fleet.vehicles(), [&](const FleetVehicle& vehicle) {
    return gives_way(vehicle) &&
           needed_deceleration(vehicle, {&person, 1}, dt) > vehicle.traits.decel;
  });
}

/// The middle of a destination's width, so narrow that a body there is within the street.
Destination with_room(const Destination& portal, double radius) {
  const Vec2 along = portal.b - portal.a;
  const double share = std::min(0.5, radius / std::max(along.norm(), 1e-9));
  return {portal.a + share * along, portal.b - share * along};
}

}  // namespace

std::size_t plan_number(int stages_left, const std::vector<std::string>& edges,
                        double arrival_position) {
  std::size_t hash = static_cast<std::size_t>(stages_left);
  for (const std::string& edge : edges) {
    hash = hash * 1099511628211ULL ^ std::hash<std::string>{}(edge);
  }
  return hash * 1099511628211ULL ^ std::hash<double>{}(arrival_position);
}

std::vector<int> zones_of_edges(const Network& network, const std::vector<Zone>& zones) {
  std::vector<int> found(network.edges.size(), -1);
  for (std::size_t z = 0; z < zones.size(); ++z) {
    for (const int edge : zones[z].edges) found[edge] = static_cast<int>(z);
  }
  return found;
}

std::optional<TakeoverPlan> plan_takeover(const Network& network, const Zone& zone, int edge,
                                          const WalkerSeen& walker, bool walked_until_now,
                                          const Fleet& fleet, PersonPast& past) {
  note_plan(walker, past);
  past.refused_edge = edge;  // unless all goes well below
  // In the step after a takeover SUMO still walks the person, but does not pass it on to its next
  // lane. Beyond the end of a short edge it hides that end from those who come after it: they walk
  // too far, and SUMO aborts.
  if (!walked_until_now && is_too_short(network, edge)) return std::nullopt;
  const std::vector<int> route = edge_indices(network, walker.edges);
  const int index = only_index(route, edge, past.last);
  if (index < 0) return std::nullopt;
  auto plan = plan_walk(network, zone, route, index, walker, walked_until_now);
  if (!plan) return std::nullopt;
  if (!walked_until_now && !worth_while(network, plan->stretch, index, walker.position)) {
    return std::nullopt;
  }
  past.refused_edge = -1;
  plan->plan = past.plan;
  plan->edges = EdgesWalked(network, route, index, plan->stretch.last);
  // SUMO walks people through vehicles. Whom it brings here inside one is put beside it. (Whom the
  // crowd walked until now is where the crowd put it.)
  const bool departs = index == 0 && walker.speed == 0.0;
  plan->from_sumo = !walked_until_now;
  plan->place_freely = plan->from_sumo && (departs || fleet.touches(plan->start, walker.radius));
  return plan;
}

bool touches_street_end(const Network& network, int edge) {
  const Edge& here = network.edges[edge];
  return is_street_end(network, here.from) || is_street_end(network, here.to);
}

bool leads_round_street_end(const Network& network, const std::string& next_edge) {
  const auto found = network.edge_index.find(next_edge);
  if (found == network.edge_index.end()) return false;
  const Edge& next = network.edges[found->second];
  return next.function == EdgeFunction::kWalkingArea && is_street_end(network, junction_of(next));
}

std::vector<bool> entries_of_zones(const Network& network, const std::vector<int>& zone_of_edge) {
  std::set<std::string> junctions;
  for (std::size_t e = 0; e < zone_of_edge.size(); ++e) {
    if (zone_of_edge[e] >= 0) junctions.insert({network.edges[e].from, network.edges[e].to});
  }
  std::vector<bool> entries(network.edges.size());
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const Edge& edge = network.edges[e];
    entries[e] = edge.function == EdgeFunction::kNormal && zone_of_edge[e] < 0 &&
                 !is_too_short(network, static_cast<int>(e)) &&
                 (junctions.contains(edge.from) || junctions.contains(edge.to));
  }
  return entries;
}

std::optional<EntryPlan> plan_entry(const Network& network, const std::vector<Zone>& zones,
                                    const std::vector<int>& zone_of_edge, int edge,
                                    const WalkerSeen& walker, bool walked_until_now, double dt,
                                    const Fleet& fleet, PersonPast& past) {
  note_plan(walker, past);
  const std::vector<int> route = edge_indices(network, walker.edges);
  const int index = only_index(route, edge, past.last);
  const int next = index + 1;
  if (index < 0 || next >= static_cast<int>(route.size()) || route[next] < 0) return std::nullopt;
  const int zone = zone_of_edge[route[next]];
  if (zone < 0) return std::nullopt;
  if (!walked_until_now && !is_about_to_leave(network, route, index, walker, dt)) {
    return std::nullopt;
  }
  auto plan = plan_walk(network, zones[zone], route, next, walker, walked_until_now);
  if (!plan) return std::nullopt;
  plan->plan = past.plan;
  plan->edges = EdgesWalked(network, route, index, plan->stretch.last);
  plan->from_sumo = !walked_until_now;
  plan->place_freely = plan->from_sumo && fleet.touches(plan->start, walker.radius);
  return EntryPlan{zone, *plan};
}

Entry entry_of(const TakeoverPlan& plan, const PersonView& view, double radius, const Fleet& fleet,
               double dt) {
  if (view.stays_outside) return Entry::kStaysOutside;
  const bool in_vehicle = plan.place_freely && fleet.touches(view.position, radius);
  const bool too_late = plan.from_sumo && could_not_stop_for(fleet, view.position, radius, dt);
  return in_vehicle || too_late ? Entry::kNoRoom : Entry::kWalks;
}

double striping_share(double dawdling) { return 1.0 - 0.5 * std::clamp(dawdling, 0.0, 1.0); }

NewPerson new_person(const WalkerSeen& walker, const TakeoverPlan& plan, const PersonHints& hints,
                     std::size_t zone, double preferred_speed) {
  NewPerson person;
  person.key = person_key(walker.id);
  person.profile = hints.profile;
  person.aware = hints.aware;
  person.group = hints.group;
  person.rates = hints.rates;
  person.path = hints.path != nullptr ? hints.path->waypoints(zone) : plan.round;
  person.position = plan.start;
  person.heading = walker.heading;
  person.velocity = unit(walker.heading) * std::min(std::max(0.0, walker.speed), preferred_speed);
  person.radius = walker.radius;
  person.preferred_speed = preferred_speed;
  person.destination = with_room(plan.stretch.destination, walker.radius);
  person.place_freely = plan.place_freely;
  person.by_junctions = plan.by_junctions;
  return person;
}

}  // namespace pedzone
