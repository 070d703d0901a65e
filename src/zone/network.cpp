#include "zone/network.hpp"

namespace pedzone {

int walking_lane(const Network& network, int edge) {
  int shared = -1;
  for (const int index : network.edges[edge].lanes) {
    const Lane& lane = network.lanes[index];
    if (!lane.persons) continue;
    if (!lane.vehicles) return index;
    if (shared < 0) shared = index;
  }
  return shared;
}

bool is_too_short(const Network& network, int edge) {
  const int lane = walking_lane(network, edge);
  return lane < 0 || network.lanes[lane].length < kShortEdge;
}

}  // namespace pedzone
