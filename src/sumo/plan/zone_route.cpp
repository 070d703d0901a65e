#include "sumo/plan/zone_route.hpp"

#include <algorithm>
#include <set>

#include "zone/lane_geometry.hpp"

namespace pedzone {
namespace {

constexpr double kLongStep = 3.0;  // [m] assumed: so far over a junction nobody watches the way

/// Whether the person leaves `edge` towards `next` at the edge's end (true) or its beginning
/// (false). Nothing when they do not meet, or when they meet at both ends and the person comes
/// from the end: SUMO would then take it forward.
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
  stretch.destination = across_lane(network.lanes[lane], stretch.position);
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

/// Whether SUMO's persons pass from one edge to the other over a single walking area.
bool share_walking_area(const Network& network, int a, int b) {
  std::set<int> beside_a, beside_b;
  for (const Connection& connection : network.connections) {
    const int from = network.lanes[connection.from].edge;
    const int to = network.lanes[connection.to].edge;
    for (const auto& [edge, area] : {std::pair(from, to), std::pair(to, from)}) {
      if (network.edges[area].function != EdgeFunction::kWalkingArea) continue;
      if (edge == a) beside_a.insert(area);
      if (edge == b) beside_b.insert(area);
    }
  }
  return std::any_of(beside_a.begin(), beside_a.end(),
                     [&](int area) { return beside_b.contains(area); });
}

/// Across the zone's last junction onto the edge after it. Nothing where SUMO would have to guess
/// in which direction the person then walks.
std::optional<ZoneStretch> step_over(const Network& network, const Zone& zone,
                                     const std::vector<int>& route, int first, int last) {
  const int next = last + 1;
  if (next + 1 >= static_cast<int>(route.size()) || !is_first_occurrence(route, next)) return {};
  const int lane = walking_lane(network, route[next]);
  const auto forward = leaves_forward(network, route[last], route[next], route[next + 1]);
  if (lane < 0 || network.lanes[lane].length < 2.0 * kPortalInset || !forward) return {};
  if (!passes_through(network, route[last], route[next], route[next + 1])) return {};
  if (!share_walking_area(network, route[last], route[next])) return {};
  ZoneStretch stretch;
  stretch.last = last;
  stretch.release = Release::kStepOver;
  stretch.lane = lane;
  stretch.forward = *forward;
  const double length = network.lanes[lane].length;
  stretch.position = *forward ? kPortalInset : length - kPortalInset;
  for (int i = first; i < last && stretch.hop_lane < 0; ++i) {
    if (!is_too_short(network, route[i]) && is_first_occurrence(route, i)) {
      stretch.hop_lane = walking_lane(network, route[i]);
    }
  }
  const Vec2 entry = point_on_lane(network.lanes[lane], *forward ? 0.0 : length).point;
  const Vec2 inside = zone.walls.nearest_inside(entry, kWayClearance);
  if (stretch.hop_lane < 0 || (inside - entry).norm() > kLongStep) return {};
  stretch.destination = {inside, inside};
  return stretch;
}

}  // namespace

bool is_too_short(const Network& network, int edge) {
  const int lane = walking_lane(network, edge);
  return lane < 0 || network.lanes[lane].length < kShortEdge;
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
  while (last + 1 < end && linked(zone, route[last], route[last + 1])) ++last;
  if (last + 1 < end) {
    if (is_too_short(network, route[last])) {
      if (const auto stretch = step_over(network, zone, route, first, last)) return stretch;
    }
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
