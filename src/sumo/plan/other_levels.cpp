#include "sumo/plan/other_levels.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/box_tree.hpp"
#include "zone/levels.hpp"
#include "zone/shapes.hpp"

namespace pedzone {
namespace {

/// How one lane passes others.
struct Passing {
  bool on_level = false, above_or_below = false;

  void look(const Lane& lane, const Lane& other) {
    for (const Polygon& polygon : intersect(area_of(lane), area_of(other))) {
      for (const Vec2& point : polygon.outer) {
        const double step = std::abs(height_near(lane, point) - height_near(other, point));
        (step > kLevelStep ? above_or_below : on_level) = true;
      }
    }
  }
};

}  // namespace

std::vector<bool> lanes_on_other_levels(const Network& network, const std::vector<Zone>& zones) {
  std::vector<bool> apart(network.lanes.size(), false);
  const auto is_high = [](const Lane& lane) {
    return std::ranges::any_of(lane.z, [](double z) { return z != 0.0; });
  };
  if (std::ranges::none_of(network.lanes, is_high)) return apart;
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
    Passing passing;
    for (const auto k : tree.meeting(box_of(lane))) passing.look(lane, network.lanes[theirs[k]]);
    apart[i] = passing.above_or_below && !passing.on_level;
  }
  return apart;
}

}  // namespace pedzone
