#include "sumo/plan/other_levels.hpp"

#include <algorithm>

#include "geometry/box_tree.hpp"
#include "zone/levels.hpp"
#include "zone/shapes.hpp"

namespace pedzone {

std::vector<bool> lanes_on_other_levels(const Network& network, const std::vector<Zone>& zones) {
  std::vector<bool> apart(network.lanes.size(), false);
  if (std::ranges::none_of(network.lanes, has_heights)) return apart;
  std::vector<bool> in_zone(network.lanes.size(), false);
  std::vector<int> theirs;
  std::vector<Box> boxes;
  for (const Zone& zone : zones) {
    for (const int lane : zone.lanes) {
      in_zone[lane] = true;
      theirs.push_back(lane);
      boxes.push_back(box_of(network.lanes[lane]));
    }
  }
  const BoxTree tree(boxes);
  for (std::size_t i = 0; i < network.lanes.size(); ++i) {
    const Lane& lane = network.lanes[i];
    if (in_zone[i] || !lane.vehicles) continue;
    const std::vector<std::size_t> near = tree.meeting(box_of(lane));
    const auto is_any = [&](const auto& passes) {
      return std::ranges::any_of(
          near, [&](std::size_t k) { return passes(lane, network.lanes[theirs[k]]); });
    };
    apart[i] = is_any(on_different_levels) && !is_any(on_one_level);
  }
  return apart;
}

}  // namespace pedzone
