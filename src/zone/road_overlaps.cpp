#include "zone/road_overlaps.hpp"

#include "zone/levels.hpp"
#include "zone/shapes.hpp"

namespace pedzone {
namespace {

// assumed: less is two shapes that touch, or a way over the road at a right angle.
constexpr double kShare = 0.25;

}  // namespace

void warn_of_roads_under_lanes(const Network& network, const Selection& selection,
                               std::vector<std::string>& warnings) {
  std::vector<std::pair<const Lane*, Box>> lanes_of_roads;
  for (const Lane& lane : network.lanes) {
    const bool road = lane.vehicles && !lane.persons &&
                      network.edges[lane.edge].function == EdgeFunction::kNormal;
    if (road) lanes_of_roads.emplace_back(&lane, box_of(lane));
  }
  for (const int index : selection.lanes) {
    const Lane& lane = network.lanes[index];
    const Region ground = area_of(lane);
    const Box box = box_of(lane);
    std::string roads;
    double covered = 0.0;
    for (const auto& [other, other_box] : lanes_of_roads) {
      if (other->edge == lane.edge || !box.intersects(other_box)) continue;
      const double common = area(intersect(ground, area_of(*other)));
      if (common <= 0.0 || on_different_levels(lane, *other)) continue;
      covered += common;
      roads += (roads.empty() ? "'" : ", '") + other->id + "'";
    }
    if (covered < kShare * area(ground)) continue;
    warnings.push_back("lane '" + lane.id + "' runs on " + roads +
                       ", which stays SUMO's: people and its vehicles meet there");
  }
}

}  // namespace pedzone
