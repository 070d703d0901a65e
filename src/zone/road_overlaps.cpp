#include "zone/road_overlaps.hpp"

#include "geometry/box_tree.hpp"
#include "zone/levels.hpp"
#include "zone/shapes.hpp"

namespace pedzone {
namespace {

// assumed: less is two shapes that touch, or a way over the road at a right angle.
constexpr double kShare = 0.25;

}  // namespace

void warn_of_roads_under_lanes(const Network& network, const Selection& selection,
                               std::vector<std::string>& warnings) {
  std::vector<const Lane*> lanes_of_roads;
  std::vector<Box> boxes;
  for (const Lane& lane : network.lanes) {
    const bool road = lane.vehicles && !lane.persons &&
                      network.edges[lane.edge].function == EdgeFunction::kNormal;
    if (!road) continue;
    lanes_of_roads.push_back(&lane);
    boxes.push_back(box_of(lane));
  }
  const BoxTree roads_by_place(boxes);
  for (const int index : selection.lanes) {
    const Lane& lane = network.lanes[index];
    const Region ground = area_of(lane);
    std::string roads;
    double covered = 0.0;
    for (const std::size_t k : roads_by_place.meeting(box_of(lane))) {
      const Lane* const other = lanes_of_roads[k];
      if (other->edge == lane.edge) continue;
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
