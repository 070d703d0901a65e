#include "view/road_look.hpp"

namespace pedzone {

RoadLook look_of(const Network& network, const Lane& lane) {
  if (lane.outline) return RoadLook::kFootArea;
  const EdgeFunction function = network.edges[lane.edge].function;
  if (function == EdgeFunction::kCrossing) return RoadLook::kCrossing;
  if (function != EdgeFunction::kNormal) return RoadLook::kHidden;
  return lane.persons && !lane.vehicles ? RoadLook::kFootway : RoadLook::kRoad;
}

}  // namespace pedzone
