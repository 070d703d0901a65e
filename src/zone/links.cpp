#include "zone/links.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace pedzone {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

bool on_foot_inside(const Edge& edge) {
  return edge.function == EdgeFunction::kWalkingArea || edge.function == EdgeFunction::kCrossing;
}

/// Walking areas and crossings (as edges), who touches whom, and which zone edges they touch.
struct FootGraph {
  std::map<int, std::set<int>> neighbours;  ///< among walking areas and crossings
  std::map<int, std::set<int>> touching;    ///< walking area → zone edges

  FootGraph(const Network& network, const std::vector<int>& edges) {
    const std::unordered_set<int> zone(edges.begin(), edges.end());
    for (const Connection& connection : network.connections) {
      const int from = network.lanes[connection.from].edge, to = network.lanes[connection.to].edge;
      const bool from_inside = on_foot_inside(network.edges[from]);
      const bool to_inside = on_foot_inside(network.edges[to]);
      if (from_inside && to_inside) {
        neighbours[from].insert(to);
        neighbours[to].insert(from);
      } else if (from_inside && zone.contains(to)) {
        touching[from].insert(to);
      } else if (to_inside && zone.contains(from)) {
        touching[to].insert(from);
      }
    }
  }
};

/// Shortest ways from one walking area over walking areas and crossings (Dijkstra; a junction has
/// a dozen of them, so the nearest is looked for in turn).
class JunctionWays {
 public:
  JunctionWays(const Network& network, const FootGraph& graph, int start) : network_(network) {
    length_[start] = 0.0;
    before_[start] = -1;
    std::set<int> done;
    for (int here = start; here >= 0; here = nearest(done)) {
      done.insert(here);
      const auto next = graph.neighbours.find(here);
      if (next == graph.neighbours.end()) continue;
      for (const int there : next->second) reach(here, there);
    }
  }

  const std::map<int, double>& lengths() const { return length_; }

  /// The edges from the start to `end`, both included.
  std::vector<int> way(int end) const {
    std::vector<int> edges;
    for (int at = end; at >= 0; at = before_.at(at)) edges.push_back(at);
    std::reverse(edges.begin(), edges.end());
    return edges;
  }

 private:
  void reach(int here, int there) {
    const double length = length_.at(here) + network_.lanes[network_.edges[there].lanes[0]].length;
    const auto [entry, fresh] = length_.emplace(there, kFar);
    if (length >= entry->second) return;
    entry->second = length;
    before_[there] = here;
  }

  int nearest(const std::set<int>& done) const {
    int best = -1;
    for (const auto& [edge, length] : length_) {
      if (!done.contains(edge) && (best < 0 || length < length_.at(best))) best = edge;
    }
    return best;
  }

  const Network& network_;
  std::map<int, double> length_;
  std::map<int, int> before_;
};

std::vector<Link> links_on_foot(const Network& network, const std::vector<int>& edges) {
  const FootGraph graph(network, edges);
  // The shortest way of each pair of edges and junction.
  std::map<std::tuple<std::string, int, int>, std::pair<double, std::vector<int>>> best;
  for (const auto& [start, starting] : graph.touching) {
    const JunctionWays ways(network, graph, start);
    const std::string junction = junction_of(network.edges[start]);
    for (const auto& [end, length] : ways.lengths()) {
      const auto ending = graph.touching.find(end);
      if (ending == graph.touching.end()) continue;
      for (const int from : starting) {
        for (const int to : ending->second) {
          if (from >= to) continue;
          auto& entry =
              best.try_emplace({junction, from, to}, kFar, std::vector<int>{}).first->second;
          if (length < entry.first) entry = {length, ways.way(end)};
        }
      }
    }
  }
  std::vector<Link> links;
  for (const auto& [key, entry] : best) {
    const auto& [junction, from, to] = key;
    if (is_street_end(network, junction) || is_rail_crossing(network, junction)) continue;
    Link link{from, to, junction, {}};
    bool signalled = false;
    for (const int edge : entry.second) {
      const Edge& inner = network.edges[edge];
      signalled |= inner.signalled;
      link.way.push_back(inner.lanes[0]);
    }
    if (!signalled) links.push_back(std::move(link));
  }
  return links;
}

std::map<std::string, std::vector<int>> edges_by_junction(const Network& network,
                                                          const std::vector<int>& edges) {
  std::map<std::string, std::vector<int>> meeting;
  for (const int edge : edges) {
    const Edge& here = network.edges[edge];
    if (!here.from.empty()) meeting[here.from].push_back(edge);
    if (!here.to.empty() && here.to != here.from) meeting[here.to].push_back(edge);
  }
  return meeting;
}

/// Pairs of edges, the smaller index first, from one of which SUMO's connections lead to the other.
std::set<std::pair<int, int>> connected_edges(const Network& network) {
  std::set<std::pair<int, int>> pairs;
  for (const Connection& connection : network.connections) {
    const int from = network.lanes[connection.from].edge, to = network.lanes[connection.to].edge;
    if (network.lanes[connection.from].persons && network.lanes[connection.to].persons) {
      pairs.insert({std::min(from, to), std::max(from, to)});
    }
  }
  return pairs;
}

/// At junctions without a walking area: netconvert builds none where two streets meet in line, nor
/// where one is cut off at the border of a network. SUMO's persons go on there by connections. In a
/// network that has none at all they step from any edge to any other.
void link_at_once(const Network& network, const std::vector<int>& edges, std::vector<Link>& links) {
  std::set<std::string> with_walking_area;
  for (const Edge& edge : network.edges) {
    if (edge.function == EdgeFunction::kWalkingArea) with_walking_area.insert(junction_of(edge));
  }
  const std::set<std::pair<int, int>> connected = connected_edges(network);
  const bool any = with_walking_area.empty();
  for (const auto& [junction, meeting] : edges_by_junction(network, edges)) {
    if (with_walking_area.contains(junction) || is_rail_crossing(network, junction)) continue;
    for (std::size_t i = 0; i < meeting.size(); ++i) {
      for (std::size_t j = i + 1; j < meeting.size(); ++j) {
        if (!any && !connected.contains({meeting[i], meeting[j]})) continue;
        links.push_back({meeting[i], meeting[j], junction, {}});
      }
    }
  }
}

/// Barriers say who goes there, too.
std::set<std::string> signalled_junctions(const Network& network) {
  std::set<std::string> junctions;
  for (const Junction& junction : network.junctions) {
    if (junction.type == "rail_crossing") junctions.insert(junction.id);
  }
  for (const Edge& edge : network.edges) {
    if (edge.signalled) junctions.insert(junction_of(edge));
  }
  return junctions;
}

/// Adds the lanes inside junctions by which vehicles drive between zone lanes: a connection's
/// `via`, and what follows it where a turn waits in the middle.
void add_vehicle_ways(const Network& network, const std::unordered_set<int>& zone_lanes,
                      std::set<int>& inside) {
  const auto signalled = signalled_junctions(network);
  std::unordered_map<int, std::pair<int, int>> next;  // lane inside → (via, to)
  for (const Connection& connection : network.connections) {
    const Edge& from = network.edges[network.lanes[connection.from].edge];
    if (from.function == EdgeFunction::kInternal) {
      next[connection.from] = {connection.via, connection.to};
    }
  }
  for (const Connection& connection : network.connections) {
    if (!zone_lanes.contains(connection.from) || !zone_lanes.contains(connection.to)) continue;
    int via = connection.via;
    if (via < 0 || signalled.contains(junction_of(network.edges[network.lanes[via].edge])))
      continue;
    while (via >= 0 && inside.insert(via).second) {
      const auto follows = next.find(via);
      via = follows == next.end() ? -1 : follows->second.first;
    }
  }
}

}  // namespace

bool leads_over_carriageway(const Network& network, int crossing) {
  return std::ranges::any_of(network.edges[crossing].crossed, [&](const std::string& id) {
    const auto found = network.edge_index.find(id);
    return found != network.edge_index.end() && has_carriageway(network, found->second);
  });
}

std::vector<Link> find_links(const Network& network, const std::vector<int>& edges) {
  auto links = links_on_foot(network, edges);
  link_at_once(network, edges, links);
  return links;
}

std::vector<int> inner_lanes(const Network& network, const std::vector<int>& lanes,
                             const std::vector<Link>& links) {
  std::set<int> inside;
  for (const Link& link : links) inside.insert(link.way.begin(), link.way.end());
  add_vehicle_ways(network, {lanes.begin(), lanes.end()}, inside);
  return {inside.begin(), inside.end()};
}

std::vector<int> shared_junctions(const Network& network, const std::vector<int>& edges) {
  const std::unordered_set<int> zone(edges.begin(), edges.end());
  auto excluded = signalled_junctions(network);
  for (int edge = 0; edge < static_cast<int>(network.edges.size()); ++edge) {
    const Edge& other = network.edges[edge];
    if (other.function != EdgeFunction::kNormal) continue;
    const bool bars = zone.contains(edge) ? has_carriageway(network, edge) : is_road(network, edge);
    if (!bars) continue;
    excluded.insert(other.from);
    excluded.insert(other.to);
  }
  std::vector<int> junctions;
  for (const auto& [id, meeting] : edges_by_junction(network, edges)) {
    const auto found = network.junction_index.find(id);
    if (meeting.size() < 2 || excluded.contains(id) || found == network.junction_index.end()) {
      continue;
    }
    junctions.push_back(found->second);
  }
  std::sort(junctions.begin(), junctions.end());
  return junctions;
}

bool is_road(const Network& network, int edge) {
  const auto& lanes = network.edges[edge].lanes;
  return std::any_of(lanes.begin(), lanes.end(), [&](int index) {
    const Lane& lane = network.lanes[index];
    return lane.vehicles || !lane.persons;
  });
}

std::string junction_of(const Edge& inner) {
  const std::size_t last = inner.id.rfind('_');
  if (inner.id.empty() || inner.id[0] != ':' || last == std::string::npos) return inner.id;
  return inner.id.substr(1, last - 1);
}

}  // namespace pedzone
