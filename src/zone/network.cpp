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

}  // namespace pedzone
