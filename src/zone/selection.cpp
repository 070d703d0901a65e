#include "zone/selection.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/error.hpp"
#include "core/text.hpp"
#include "zone/links.hpp"

namespace pedzone {
namespace {

constexpr std::string_view kPedestrianStreet = "highway.pedestrian";
constexpr std::string_view kLivingStreet = "highway.living_street";

/// A lane for persons only beside lanes for vehicles.
bool is_sidewalk(const Network& network, const Lane& lane) {
  const auto& lanes = network.edges[lane.edge].lanes;
  return lane.persons && !lane.vehicles && std::any_of(lanes.begin(), lanes.end(), [&](int other) {
           return network.lanes[other].vehicles;
         });
}

/// Adds what a spec names, one attribute after the other.
class NamedSelection {
 public:
  NamedSelection(const Network& network, const ZoneSpec& spec, const std::vector<bool>& taken)
      : network_(network), spec_(spec), taken_(taken) {
    for (const std::string& id : spec.edges) add_edge(id);
    for (const std::string& type : spec.edge_types) add_type(type);
    for (const std::string& id : spec.lanes) add_lane(id);
  }

  Selection result() const {
    return {{edges_.begin(), edges_.end()}, {lanes_.begin(), lanes_.end()}};
  }

 private:
  void add_edge(const std::string& id) {
    const auto found = network_.edge_index.find(id);
    if (found == network_.edge_index.end()) {
      throw zone_error(spec_, "is no edge", "edges", id, "ids of edges in " + network_.file);
    }
    const Edge& edge = network_.edges[found->second];
    if (edge.function != EdgeFunction::kNormal) {
      throw zone_error(spec_, "lies inside a junction", "edges", id,
                       "edges between junctions; what connects them comes with them");
    }
    if (walking_lane(network_, found->second) < 0) {
      throw zone_error(spec_, "has no lane that persons may use", "edges", id,
                       "edges with a lane that allows pedestrian");
    }
    take(found->second);
  }

  void add_type(const std::string& type) {
    bool known = false;
    for (int edge = 0; edge < static_cast<int>(network_.edges.size()); ++edge) {
      if (!has_type(network_.edges[edge], type)) continue;
      known = true;
      if (walking_lane(network_, edge) >= 0) take(edge);
    }
    if (known) return;
    std::set<std::string> types;
    for (const Edge& edge : network_.edges) {
      if (!edge.type.empty()) types.insert(edge.type);
    }
    const std::string allowed = comma_list(types);
    throw zone_error(spec_, "is the type of no edge", "edgeTypes", type,
                     allowed.empty() ? "none: the network's edges have no types" : allowed);
  }

  /// A lane brings its edge in. Its persons walk on the walking lane, which comes with it.
  void add_lane(const std::string& id) {
    const auto found = network_.lane_index.find(id);
    if (found == network_.lane_index.end()) {
      throw zone_error(spec_, "is no lane", "lanes", id, "ids of lanes in " + network_.file);
    }
    const Lane& lane = network_.lanes[found->second];
    if (network_.edges[lane.edge].function != EdgeFunction::kNormal) {
      throw zone_error(spec_, "lies inside a junction", "lanes", id, "lanes between junctions");
    }
    if (!lane.persons) {
      throw zone_error(spec_, "may not be used by persons", "lanes", id,
                       "lanes that allow pedestrian");
    }
    if (taken_[lane.edge]) return;
    edges_.insert(lane.edge);
    lanes_.insert(found->second);
    lanes_.insert(walking_lane(network_, lane.edge));
  }

  void take(int edge) {
    if (taken_[edge]) return;
    edges_.insert(edge);
    for (const int lane : network_.edges[edge].lanes) {
      if (network_.lanes[lane].persons) lanes_.insert(lane);
    }
  }

  const Network& network_;
  const ZoneSpec& spec_;
  const std::vector<bool>& taken_;
  std::set<int> edges_, lanes_;
};

/// Whether it is a stub for people only between two of those junctions: where netconvert has cut a
/// path to nearly nothing, people would be SUMO's for a step in the middle of the zone.
bool is_stub(const Network& network, int edge, const std::set<std::string>& junctions) {
  const Edge& its = network.edges[edge];
  return its.function == EdgeFunction::kNormal && !is_road(network, edge) &&
         is_too_short(network, edge) && junctions.contains(its.from) && junctions.contains(its.to);
}

void add_stubs(const Network& network, const std::vector<bool>& taken, Selection& selection) {
  std::set<std::string> junctions;
  for (const int edge : selection.edges) {
    junctions.insert({network.edges[edge].from, network.edges[edge].to});
  }
  std::set<int> edges(selection.edges.begin(), selection.edges.end());
  for (int edge = 0; edge < static_cast<int>(network.edges.size()); ++edge) {
    if (taken[edge] || !is_stub(network, edge, junctions) || !edges.insert(edge).second) continue;
    selection.lanes.push_back(walking_lane(network, edge));
  }
  selection.edges.assign(edges.begin(), edges.end());
}

Selection select_by_rule(const Network& network, const std::vector<bool>& taken) {
  Selection selection;
  for (int edge = 0; edge < static_cast<int>(network.edges.size()); ++edge) {
    if (taken[edge] || network.edges[edge].function != EdgeFunction::kNormal) continue;
    const int walking = walking_lane(network, edge);
    if (walking < 0 || !is_shared_space(network, walking)) continue;
    selection.edges.push_back(edge);
    for (const int lane : network.edges[edge].lanes) {
      if (is_shared_space(network, lane)) selection.lanes.push_back(lane);
    }
  }
  add_stubs(network, taken, selection);
  std::sort(selection.lanes.begin(), selection.lanes.end());
  return selection;
}

using LengthsByType = std::map<std::string, TypeLength>;

void add_length(const Network& network, int edge, LengthsByType& lengths) {
  TypeLength& entry = lengths[network.edges[edge].type];
  entry.type = network.edges[edge].type;
  entry.length += network.lanes[walking_lane(network, edge)].length;
  ++entry.edges;
}

std::vector<TypeLength> longest_first(const LengthsByType& lengths) {
  std::vector<TypeLength> list;
  for (const auto& [type, entry] : lengths) list.push_back(entry);
  std::stable_sort(list.begin(), list.end(),
                   [](const auto& a, const auto& b) { return a.length > b.length; });
  return list;
}

}  // namespace

void leave_out(const Network& network, const std::function<bool(int edge)>& is_out,
               Selection& selection) {
  std::erase_if(selection.edges, is_out);
  std::erase_if(selection.lanes, [&](int lane) { return is_out(network.lanes[lane].edge); });
}

bool has_type(const Edge& edge, std::string_view type) {
  std::string_view rest = edge.type;
  if (rest == type) return true;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('|'), rest.size());
    if (rest.substr(0, end) == type) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

bool is_shared_space(const Network& network, int index) {
  const Lane& lane = network.lanes[index];
  const Edge& edge = network.edges[lane.edge];
  if (edge.function != EdgeFunction::kNormal || !lane.persons) return false;
  if (has_type(edge, kPedestrianStreet)) return true;
  if (has_type(edge, kLivingStreet)) return !is_sidewalk(network, lane);
  return lane.vehicles && !lane.persons_only_by_default && lane.speed <= kSharedSpaceSpeed;
}

Selection select_lanes(const Network& network, const ZoneSpec& spec,
                       const std::vector<bool>& taken) {
  Selection selection = spec.automatic() ? select_by_rule(network, taken)
                                         : NamedSelection(network, spec, taken).result();
  if (!selection.edges.empty()) return selection;
  if (spec.file.empty()) {
    throw InputError("has no shared space",
                     {.file = network.file,
                      .element = "<net>",
                      .allowed = "edges of type highway.pedestrian or highway.living_street, lanes "
                                 "open to pedestrians and vehicles at up to 5.6 m/s, or a zone "
                                 "file that names edges"});
  }
  throw zone_error(spec, "is empty", "", "",
                   "at least one edge that persons may use and no earlier zone has");
}

std::vector<TypeLength> lengths_inside(const Network& network, const std::vector<int>& edges) {
  LengthsByType lengths;
  for (const int edge : edges) add_length(network, edge, lengths);
  return longest_first(lengths);
}

std::vector<TypeLength> lengths_left_out(const Network& network, const std::vector<bool>& taken) {
  LengthsByType lengths;
  for (int edge = 0; edge < static_cast<int>(network.edges.size()); ++edge) {
    if (taken[edge] || network.edges[edge].function != EdgeFunction::kNormal) continue;
    if (walking_lane(network, edge) < 0) continue;
    add_length(network, edge, lengths);
    TypeLength& entry = lengths[network.edges[edge].type];
    if (!entry.type.empty()) {
      entry.bring_in = "edgeTypes=\"" + entry.type + "\"";
    } else if (entry.edges == 1) {
      entry.bring_in = "edges=\"" + network.edges[edge].id + "\"";
    } else if (entry.edges == 2) {
      entry.bring_in.insert(entry.bring_in.size() - 1, " ...");
    }
  }
  return longest_first(lengths);
}

}  // namespace pedzone
