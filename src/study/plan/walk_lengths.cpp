#include "study/plan/walk_lengths.hpp"

#include <functional>
#include <map>
#include <queue>

namespace pedzone::study {

WalkLengths::WalkLengths(const Network& network, const std::unordered_set<int>& zone_edges)
    : network_(network), zone_edges_(zone_edges) {
  for (int edge = 0; edge < static_cast<int>(network.edges.size()); ++edge) {
    const Edge& of = network.edges[edge];
    if (of.function != EdgeFunction::kNormal || walking_lane(network, edge) < 0) continue;
    steps_[of.from].push_back({edge, of.to});
    steps_[of.to].push_back({edge, of.from});  // people walk against the traffic, too
  }
}

std::optional<int> WalkLengths::edge_of(const std::string& id) const {
  const auto found = network_.edge_index.find(id);
  if (found == network_.edge_index.end()) return std::nullopt;
  const bool normal = network_.edges[found->second].function == EdgeFunction::kNormal;
  if (!normal || walking_lane(network_, found->second) < 0) return std::nullopt;
  return found->second;
}

double WalkLengths::length(int edge) const {
  return network_.lanes[walking_lane(network_, edge)].length;
}

WalkLength WalkLengths::plus(WalkLength so_far, int edge) const {
  so_far.total += length(edge);
  if (zone_edges_.contains(edge)) so_far.in_zone += length(edge);
  return so_far;
}

std::optional<WalkLength> WalkLengths::along(const std::vector<std::string>& edges) const {
  WalkLength sum;
  for (const std::string& id : edges) {
    const auto edge = edge_of(id);
    if (!edge) return std::nullopt;
    sum = plus(sum, *edge);
  }
  return edges.empty() ? std::nullopt : std::optional(sum);
}

std::optional<WalkLength> WalkLengths::between(const std::string& from,
                                               const std::string& to) const {
  const auto first = edge_of(from), last = edge_of(to);
  if (!first || !last) return std::nullopt;
  if (first == last) return plus({}, *first);
  using Reached = std::pair<double, std::string>;  // [m], junction
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  std::map<std::string, WalkLength> known;
  const auto reach = [&](const std::string& junction, const WalkLength& way) {
    const auto [found, is_new] = known.try_emplace(junction, way);
    if (!is_new && found->second.total <= way.total) return;
    found->second = way;
    queue.emplace(way.total, junction);
  };
  const Edge& start = network_.edges[*first];
  const Edge& goal = network_.edges[*last];
  for (const std::string& end : {start.from, start.to}) reach(end, plus({}, *first));
  while (!queue.empty()) {
    const auto [total, junction] = queue.top();
    queue.pop();
    const WalkLength way = known.at(junction);
    if (way.total < total) continue;
    if (junction == goal.from || junction == goal.to) return plus(way, *last);
    for (const Step& step : steps_.at(junction)) reach(step.to, plus(way, step.edge));
  }
  return std::nullopt;
}

}  // namespace pedzone::study
