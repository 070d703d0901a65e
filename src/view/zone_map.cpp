#include "view/zone_map.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "view/road_look.hpp"

namespace pedzone {
namespace {

void draw_road(SvgPage& page, const Network& network, const Lane& lane, const MapLook& look) {
  const RoadLook road = look_of(network, lane);
  if (road == RoadLook::kHidden) return;
  if (road == RoadLook::kFootArea) {
    page.region(repair(lane.shape), fmt::format("fill=\"{}\"", look.footway), lane.id);
    return;
  }
  const std::string_view colour = road == RoadLook::kCrossing  ? look.crossing
                                  : road == RoadLook::kFootway ? look.footway
                                                               : look.road;
  page.line(lane.shape, stroke(colour, lane.width), lane.id + " " + network.edges[lane.edge].type);
}

void draw_roads(SvgPage& page, const Network& network, std::span<const Zone> zones,
                const MapLook& look) {
  std::unordered_set<int> inside;
  for (const Zone& zone : zones) inside.insert(zone.lanes.begin(), zone.lanes.end());
  page.begin_group("stroke-linejoin=\"round\"");
  for (const Junction& junction : network.junctions) {
    const Region shape = repair(junction.shape);
    if (!page.box().intersects(box_of(shape))) continue;
    page.region(shape, fmt::format("fill=\"{}\"", look.road), "junction " + junction.id);
  }
  for (const bool footways : {false, true}) {
    for (int index = 0; index < static_cast<int>(network.lanes.size()); ++index) {
      const Lane& lane = network.lanes[index];
      const bool footway = lane.persons && !lane.vehicles;
      if (inside.contains(index) || footway != footways) continue;
      if (page.box().intersects(box_of(lane))) draw_road(page, network, lane, look);
    }
  }
  page.end_group();
}

}  // namespace

std::string stroke(std::string_view colour, double width) {
  return fmt::format("stroke=\"{}\" stroke-width=\"{:.2f}\"", escaped(colour), width);
}

std::string MapLook::walkable_style(std::size_t zone) const {
  return fmt::format("fill=\"{}\" ", zones[zone % zones.size()]) + stroke(border, line);
}

std::string MapLook::obstacle_style() const {
  return fmt::format("fill=\"{}\" ", obstacle) + stroke(obstacle_border, 0.8 * line);
}

void draw_zone_map(SvgPage& page, const Network& network, std::span<const Zone> zones,
                   const MapLook& look) {
  draw_roads(page, network, zones, look);
  for (std::size_t i = 0; i < zones.size(); ++i) {
    page.region(zones[i].walkable, look.walkable_style(i), "zone " + zones[i].id);
  }
  for (const Zone& zone : zones) page.region(zone.obstacles, look.obstacle_style());
}

}  // namespace pedzone
