#include "demand/foot_network.hpp"

#include <numeric>
#include <unordered_map>
#include <unordered_set>

namespace pedzone {
namespace {

bool on_foot_inside(const Edge& edge) {
  return edge.function == EdgeFunction::kWalkingArea || edge.function == EdgeFunction::kCrossing;
}

/// Sets that are joined, each named by one of its members.
class Parts {
 public:
  explicit Parts(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int part(int member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }

  void join(int a, int b) { parent_[part(a)] = part(b); }

 private:
  std::vector<int> parent_;
};

}  // namespace

std::vector<int> foot_parts(const Network& network) {
  Parts parts(network.edges.size());
  std::unordered_set<std::string> with_areas;  // junctions
  const auto walkable = [&](int edge) { return walking_lane(network, edge) >= 0; };
  for (const Connection& connection : network.connections) {
    const int from = network.lanes[connection.from].edge, to = network.lanes[connection.to].edge;
    const Edge &here = network.edges[from], &there = network.edges[to];
    if (!on_foot_inside(here) && !on_foot_inside(there)) continue;
    if (!walkable(from) || !walkable(to)) continue;
    parts.join(from, to);
    if (here.function == EdgeFunction::kNormal) with_areas.insert(here.to);
    if (there.function == EdgeFunction::kNormal) with_areas.insert(there.from);
  }
  // Where a junction has no walking areas, SUMO's persons pass between all edges that meet there.
  std::unordered_map<std::string, int> first_at;
  std::vector<int> result(network.edges.size(), -1);
  for (int edge = 0; edge < static_cast<int>(network.edges.size()); ++edge) {
    if (network.edges[edge].function != EdgeFunction::kNormal || !walkable(edge)) continue;
    for (const std::string& junction : {network.edges[edge].from, network.edges[edge].to}) {
      if (with_areas.contains(junction)) continue;
      const auto [first, fresh] = first_at.emplace(junction, edge);
      if (!fresh) parts.join(edge, first->second);
    }
  }
  for (int edge = 0; edge < static_cast<int>(network.edges.size()); ++edge) {
    if (walkable(edge)) result[edge] = parts.part(edge);
  }
  return result;
}

}  // namespace pedzone
