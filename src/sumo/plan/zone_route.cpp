#include "sumo/plan/zone_route.hpp"

#include <algorithm>
#include <utility>

#include "zone/lane_geometry.hpp"

namespace pedzone {
namespace {

constexpr double kShortStep = 1.0;  // [m] numerical: from the zone's wall to where an edge begins
constexpr double kLongStep = 3.0;   // [m] assumed: so far over a junction nobody watches the way
constexpr double kTwoBeside = 1.0;  // [m] assumed: two leave beside each other
constexpr double kBody = 0.24;      // [m] the radius of most
constexpr double kWayRound = 1.5;   // numerical: a longer way than so many times the straight one

/// Whether a person comes through `next` from one end to the other on its way from `edge` to
/// `after`. Where it would turn round on it, SUMO 1.15 walks it off the wrong end.
bool passes_through(const Network& network, int edge, int next, int after) {
  const auto forward = leaves_forward(network, edge, next, after);
  if (!forward) return false;
  const std::string& entered_at = *forward ? network.edges[next].from : network.edges[next].to;
  return network.edges[edge].from == entered_at || network.edges[edge].to == entered_at;
}

Destination across_lane(const Lane& lane, double position) {
  const LinePoint middle = point_on_lane(lane, position);
  const Vec2 half = left_of(middle.direction) * (0.5 * lane.width);
  return {middle.point + half, middle.point - half};
}

/// Of a lane that vehicles use as well people leave at its outer side, out of their way.
Destination at_lane_end(const Network& network, const Lane& lane, double position) {
  Destination whole = across_lane(lane, position);
  if (!lane.vehicles) return whole;
  if (!network.left_hand) std::swap(whole.a, whole.b);
  const double outer = std::max(kTwoBeside, 0.5 * lane.width - (kClearOfVehicles - kBody));
  const double share = std::min(1.0, outer / std::max(lane.width, kTwoBeside));
  return {whole.a, whole.a + share * (whole.b - whole.a)};
}

std::optional<ZoneStretch> leave_at(const Network& network, const std::vector<int>& route,
                                    int index) {
  const int edge = route[index];
  const int lane = walking_lane(network, edge);
  const int hop = walking_lane(network, route[index + 1]);
  const auto forward =
      leaves_forward(network, index > 0 ? route[index - 1] : -1, edge, route[index + 1]);
  if (lane < 0 || hop < 0 || !forward) return std::nullopt;
  if (index + 2 < static_cast<int>(route.size()) && route[index + 2] >= 0 &&
      !passes_through(network, edge, route[index + 1], route[index + 2])) {
    return std::nullopt;
  }
  if (network.edges[route[index + 1]].id == network.edges[edge].id) return std::nullopt;
  ZoneStretch stretch;
  stretch.last = index;
  stretch.release = Release::kLeave;
  stretch.lane = lane;
  stretch.hop_lane = hop;
  stretch.forward = *forward;
  const double length = network.lanes[lane].length;
  stretch.position = *forward ? length - kPortalInset : kPortalInset;
  stretch.destination = at_lane_end(network, network.lanes[lane], stretch.position);
  return stretch;
}

std::optional<ZoneStretch> arrive_at(const Network& network, const std::vector<int>& route,
                                     int index, double arrival_position) {
  const Edge& edge = network.edges[route[index]];
  ZoneStretch stretch;
  stretch.last = index;
  stretch.lane = walking_lane(network, route[index]);
  if (stretch.lane < 0) return std::nullopt;
  stretch.release = Release::kArrive;
  if (index > 0) {
    stretch.hop_lane = walking_lane(network, route[index - 1]);
  } else {
    for (const int lane : edge.lanes) {
      if (lane != stretch.lane) stretch.hop_lane = lane;
    }
    if (stretch.hop_lane < 0) stretch.release = Release::kRemoveStage;
  }
  const Lane& lane = network.lanes[stretch.lane];
  stretch.position = std::clamp(arrival_position, 0.0, lane.length);
  stretch.destination = across_lane(lane, stretch.position);
  return stretch;
}

/// The walking areas that an edge is joined to.
std::vector<int> walking_areas_beside(const Network& network, int edge) {
  std::vector<int> areas;
  for (const Connection& connection : network.connections) {
    const int from = network.lanes[connection.from].edge, to = network.lanes[connection.to].edge;
    if (from != edge && to != edge) continue;
    const int other = from == edge ? to : from;
    if (network.edges[other].function == EdgeFunction::kWalkingArea) areas.push_back(other);
  }
  return areas;
}

/// Across the lane's end at `position` [m] as far as the zone's walls let people; nothing where
/// they end more than `farthest` [m] before it.
std::optional<Destination> before_entry(const Zone& zone, const Lane& lane, double position,
                                        double farthest) {
  const Destination entry = across_lane(lane, position);
  const Vec2 middle = 0.5 * (entry.a + entry.b);
  const Vec2 inside = zone.walls.nearest_inside(middle, kWayClearance);
  if ((inside - middle).norm() > farthest) return std::nullopt;
  const auto to_side = [&](const Vec2& end) -> Vec2 {
    const Vec2 at = zone.walls.nearest_inside(inside + (end - middle), kWayClearance);
    return (at - inside).norm() <= (end - middle).norm() ? at : inside;
  };
  return Destination{to_side(entry.a), to_side(entry.b)};
}

/// Whether people get there from the edge's nearer end with no long way round.
bool is_near_end(const Network& network, const Zone& zone, int edge, const Destination& there) {
  const Polyline& shape = network.lanes[walking_lane(network, edge)].shape;
  const Vec2 middle = 0.5 * (there.a + there.b);
  const double front = (shape.front() - middle).norm(), back = (shape.back() - middle).norm();
  const Vec2 end = front < back ? shape.front() : shape.back();
  return zone.ways.distance(end, middle) <= kWayRound * std::min(front, back) + kShortStep;
}

/// The lane of an edge of the stretch that SUMO can put a person on for a moment; -1: none.
int hop_within(const Network& network, const std::vector<int>& route, int first, int last) {
  for (int i = first; i <= last; ++i) {
    if (!is_too_short(network, route[i]) && is_first_occurrence(route, i)) {
      return walking_lane(network, route[i]);
    }
  }
  return -1;
}

/// Whether people come from route[index] to the edge after it inside the zone, where SUMO's do. The
/// two sides of a street meet at both of its ends: where SUMO's would cross a signalled crossing
/// near them, the way round by the other end can be long. (Who is about to go round a street's end
/// is not taken over, takeover_plan.hpp.)
bool goes_on(const Network& network, const Zone& zone, const std::vector<int>& route, int index) {
  const int edge = route[index], next = route[index + 1];
  if (!linked(zone, edge, next)) return false;
  const Edge& here = network.edges[edge];
  const auto forward = leaves_forward(network, index > 0 ? route[index - 1] : -1, edge, next);
  if (forward) return linked(zone, edge, next, *forward ? here.to : here.from);
  const auto passes = [&](const std::string& junction) {
    return linked(zone, edge, next, junction) || is_street_end(network, junction);
  };
  return passes(here.from) && passes(here.to);
}

/// Across the zone's last junction onto the edge after it, where the crowd can walk the person all
/// the way: SUMO would squeeze it past vehicles that stand there. Behind an edge too short to be
/// put on, also where the last metres are not the zone's. Nothing where SUMO would have to guess in
/// which direction the person then walks.
std::optional<ZoneStretch> step_over(const Network& network, const Zone& zone,
                                     const std::vector<int>& route, int first, int last) {
  const int next = last + 1;
  if (next + 1 >= static_cast<int>(route.size()) || !is_first_occurrence(route, next)) return {};
  const int lane = walking_lane(network, route[next]);
  const auto forward = leaves_forward(network, route[last], route[next], route[next + 1]);
  if (lane < 0 || network.lanes[lane].length < 2.0 * kPortalInset || !forward) return {};
  if (!passes_through(network, route[last], route[next], route[next + 1])) return {};
  ZoneStretch stretch;
  stretch.last = last;
  stretch.release = Release::kStepOver;
  stretch.lane = lane;
  stretch.hop_lane = hop_within(network, route, first, last);
  stretch.forward = *forward;
  const double length = network.lanes[lane].length;
  stretch.position = *forward ? kEntryInset : length - kEntryInset;
  const auto there = before_entry(zone, network.lanes[lane], *forward ? 0.0 : length,
                                  is_too_short(network, route[last]) ? kLongStep : kShortStep);
  if (stretch.hop_lane < 0 || !there) return {};
  if (!share_walking_area(network, route[last], route[next])) return {};
  if (!is_near_end(network, zone, route[last], *there)) return {};
  stretch.destination = *there;
  return stretch;
}

}  // namespace

std::optional<bool> leaves_forward(const Network& network, int before, int edge, int next) {
  const Edge& here = network.edges[edge];
  const Edge& there = network.edges[next];
  const bool at_end = here.to == there.from || here.to == there.to;
  const bool at_begin = here.from == there.from || here.from == there.to;
  if (at_end && at_begin) {
    if (before < 0) return std::nullopt;
    const Edge& previous = network.edges[before];
    const bool came_from_begin = here.from == previous.from || here.from == previous.to;
    return came_from_begin ? std::optional(true) : std::nullopt;
  }
  if (at_end) return true;
  if (at_begin) return false;
  return std::nullopt;
}

bool share_walking_area(const Network& network, int a, int b) {
  const std::vector<int> areas = walking_areas_beside(network, a);
  const std::vector<int> others = areas.empty() ? areas : walking_areas_beside(network, b);
  return std::ranges::find_first_of(areas, others) != areas.end();
}

bool is_first_occurrence(const std::vector<int>& route, int index) {
  return std::find(route.begin(), route.begin() + index, route[index]) == route.begin() + index;
}

std::vector<int> edge_indices(const Network& network, const std::vector<std::string>& edges) {
  std::vector<int> route;
  route.reserve(edges.size());
  for (const std::string& edge : edges) {
    const auto found = network.edge_index.find(edge);
    route.push_back(found == network.edge_index.end() ? -1 : found->second);
  }
  return route;
}

std::optional<ZoneStretch> plan_stretch(const Network& network, const Zone& zone,
                                        const std::vector<int>& route, int first,
                                        double arrival_position) {
  int last = first;
  const int end = static_cast<int>(route.size());
  while (last + 1 < end && goes_on(network, zone, route, last)) ++last;
  if (last + 1 < end) {
    if (const auto stretch = step_over(network, zone, route, first, last)) return stretch;
  }
  for (; last >= first; --last) {
    if (is_too_short(network, route[last])) continue;
    if (!is_first_occurrence(route, last)) continue;
    const auto stretch = last + 1 < end ? leave_at(network, route, last)
                                        : arrive_at(network, route, last, arrival_position);
    if (stretch) return stretch;
  }
  return std::nullopt;
}

}  // namespace pedzone
