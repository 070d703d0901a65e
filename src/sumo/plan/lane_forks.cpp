#include "sumo/plan/lane_forks.hpp"

namespace pedzone {

LaneForks::LaneForks(const Network& network) : network_(network) {
  std::set<std::pair<int, int>> led;  // lane, next edge
  for (const Connection& connection : network.connections) {
    const int edge = network.lanes[connection.from].edge;
    const int next = network.lanes[connection.to].edge;
    if (!led.emplace(connection.from, next).second) forks_.emplace(edge, next);
  }
}

bool LaneForks::ahead(std::span<const int> route, int index, double distance) const {
  const auto begin = static_cast<std::size_t>(index);
  for (std::size_t k = begin; k + 1 < route.size() && distance > 0.0; ++k) {
    if (forks_.contains({route[k], route[k + 1]})) return true;
    if (route[k + 1] < 0) continue;
    distance -= network_.lanes[network_.edges[route[k + 1]].lanes.front()].length;
  }
  return false;
}

}  // namespace pedzone
