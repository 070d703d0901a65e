#include "demand/places.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.hpp"
#include "geometry/polyline.hpp"

namespace pedzone {
namespace {

constexpr double kApart = 15.0;  // [m] assumed: a shorter walk is none
constexpr int kDraws = 50;       // numerical: then the longest of them is taken
constexpr double kInset = 1.0;   // [m] from the ends of an edge, where junctions begin
constexpr double kSide = 0.4;    // [m] assumed: half the distance of two who walk abreast
constexpr double kRow = 0.9;     // [m] assumed: from one row of a group to the next

const Zone& zone_named(const DemandInput& input, const PanelSpec& spec) {
  const auto found = std::ranges::find(input.zones, spec.zone, &Zone::id);
  if (found != input.zones.end()) return *found;
  throw panel_error(spec.text, "is no zone", "zone", spec.zone, comma_list(input.zones, &Zone::id));
}

/// Edges of the panel's zones that are long enough, ascending.
std::set<int> zone_edges(const DemandInput& input, const PanelSpec& spec) {
  std::set<int> edges;
  const auto add = [&](const Zone& zone) {
    for (const int edge : zone.edges) {
      if (!is_too_short(input.network, edge)) edges.insert(edge);
    }
  };
  if (!spec.zone.empty()) {
    add(zone_named(input, spec));
  } else {
    for (const Zone& zone : input.zones) add(zone);
  }
  return edges;
}

int edge_named(const Network& network, const PanelSpec& spec, const char* attribute,
               const std::string& id) {
  const auto found = network.edge_index.find(id);
  if (found == network.edge_index.end()) {
    throw panel_error(spec.text, "is no edge", attribute, id, "ids of edges in " + network.file);
  }
  if (network.edges[found->second].function != EdgeFunction::kNormal) {
    throw panel_error(spec.text, "lies inside a junction", attribute, id,
                      "edges between junctions");
  }
  if (walking_lane(network, found->second) < 0) {
    throw panel_error(spec.text, "has no lane that persons may use", attribute, id,
                      "edges with a lane that allows pedestrian");
  }
  return found->second;
}

}  // namespace

Places::Places(const DemandInput& input, const PanelSpec& spec, const std::vector<int>& parts)
    : network_(input.network), parts_(parts) {
  if (!spec.zone.empty()) zone_named(input, spec);
  from_ = choose(input, spec, "from");
  to_ = choose(input, spec, "to");
  keep_joined(spec);
}

Places::Choice Places::choose(const DemandInput& input, const PanelSpec& spec,
                              const char* attribute) const {
  const auto& named = attribute == std::string_view("from") ? spec.from : spec.to;
  Choice choice;
  for (const std::string& id : named) {
    choice.edges.push_back(edge_named(network_, spec, attribute, id));
  }
  if (named.empty()) {
    const std::set<int> edges = zone_edges(input, spec);
    choice.edges.assign(edges.begin(), edges.end());
  }
  for (const int edge : choice.edges) {
    choice.weights.push_back(lane_of(edge).length * lane_of(edge).width);
  }
  return choice;
}

/// Leaves out origins from which no destination can be reached.
void Places::keep_joined(const PanelSpec& spec) {
  std::set<int> reached;
  for (const int edge : to_.edges) reached.insert(parts_[edge]);
  double sum = 0.0;
  for (std::size_t i = 0; i < from_.edges.size(); ++i) {
    if (!reached.contains(parts_[from_.edges[i]])) from_.weights[i] = 0.0;
    sum += from_.weights[i];
  }
  if (sum > 0.0) return;
  const char* attribute = !spec.to.empty() ? "to" : !spec.from.empty() ? "from" : "";
  std::string edges;
  for (const std::string& id : !spec.to.empty() ? spec.to : spec.from) {
    edges += (edges.empty() ? "" : " ") + id;
  }
  throw panel_error(spec.text, "cannot be reached on foot", attribute, edges,
                    "edges between which persons can walk, 2 m long or more");
}

PlannedPlace Places::place_on(const Choice& choice, Draws& draws) const {
  PlannedPlace place;
  place.edge = choice.edges[draws.index(choice.weights)];
  const Lane& lane = lane_of(place.edge);
  const double inset = std::min(kInset, 0.25 * lane.length);
  place.position = draws.uniform(inset, lane.length - inset);
  place.lateral = draws.uniform(-0.5, 0.5) * lane.width;
  return place;
}

Vec2 Places::point(const PlannedPlace& place) const {
  const Lane& lane = lane_of(place.edge);
  return point_on(lane.shape, place.position / lane.length * length_of(lane.shape)).point;
}

Places::Trip Places::draw(Draws& draws) const {
  Trip best;
  double farthest = -1.0;
  for (int i = 0; i < kDraws && farthest < kApart; ++i) {
    Trip trip;
    trip.from = place_on(from_, draws);
    Choice to = to_;
    for (std::size_t k = 0; k < to.edges.size(); ++k) {
      if (parts_[to.edges[k]] != parts_[trip.from.edge]) to.weights[k] = 0.0;
    }
    trip.to = place_on(to, draws);
    const double distance = (point(trip.to) - point(trip.from)).norm();
    if (distance <= farthest) continue;
    farthest = distance;
    best = trip;
  }
  return best;
}

PlannedPlace Places::beside(const PlannedPlace& place, int member, double width) const {
  const Lane& lane = lane_of(place.edge);
  const double inset = std::min(kInset, 0.25 * lane.length);
  const double room = std::max(0.0, 0.5 * (lane.width - width));
  // Two abreast, rows one behind the other; the first where the group is.
  const double side = member % 2 == 0 ? 0.0 : 2.0 * kSide;
  const double inward = place.lateral > 0.0 ? -side : side;
  PlannedPlace result = place;
  result.position = place.position - kRow * (member / 2);
  if (result.position < inset) result.position = place.position + kRow * (member / 2);
  result.position = std::clamp(result.position, inset, lane.length - inset);
  result.lateral = std::clamp(place.lateral + inward, -room, room);
  return result;
}

}  // namespace pedzone
