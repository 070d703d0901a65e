#include "view/zone_map.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "pages/palette.hpp"
#include "view/road_look.hpp"

namespace pedzone {

using namespace colours;

namespace {

void draw_road(SvgPage& page, const Network& network, const Lane& lane) {
  const RoadLook road = look_of(network, lane);
  if (road == RoadLook::kHidden) return;
  if (road == RoadLook::kFootArea) {
    page.region(repair(lane.shape), filled(kFootway.light), lane.id);
    return;
  }
  const std::string_view colour = road == RoadLook::kCrossing  ? kCrossing.light
                                  : road == RoadLook::kFootway ? kFootway.light
                                                               : kRoad.light;
  page.line(lane.shape, stroke(colour, lane.width), lane.id + " " + network.edges[lane.edge].type);
}

void draw_roads(SvgPage& page, const Network& network, std::span<const Zone> zones) {
  std::unordered_set<int> inside;
  for (const Zone& zone : zones) inside.insert(zone.lanes.begin(), zone.lanes.end());
  page.begin_group("stroke-linejoin=\"round\"");
  for (const Junction& junction : network.junctions) {
    const Region shape = repair(junction.shape);
    if (!page.box().intersects(box_of(shape))) continue;
    page.region(shape, filled(kRoad.light), "junction " + junction.id);
  }
  for (const bool footways : {false, true}) {
    for (int index = 0; index < static_cast<int>(network.lanes.size()); ++index) {
      const Lane& lane = network.lanes[index];
      const bool footway = lane.persons && !lane.vehicles;
      if (inside.contains(index) || footway != footways) continue;
      if (page.box().intersects(box_of(lane))) draw_road(page, network, lane);
    }
  }
  page.end_group();
}

}  // namespace

std::string filled(std::string_view colour) { return fmt::format("fill=\"{}\"", escaped(colour)); }

std::string stroke(std::string_view colour, double width) {
  return fmt::format("stroke=\"{}\" stroke-width=\"{:.2f}\"", escaped(colour), width);
}

std::string walkable_style(std::size_t zone, double line) {
  return filled(kZones[zone % kZones.size()].light) + " " + stroke(kZoneEdge.light, line);
}

std::string obstacle_style(double line) {
  return filled(kObstacle.light) + " " + stroke(kObstacleEdge.light, 0.8 * line);
}

void draw_zone_map(SvgPage& page, const Network& network, std::span<const Zone> zones,
                   double line) {
  draw_roads(page, network, zones);
  for (std::size_t i = 0; i < zones.size(); ++i) {
    page.region(zones[i].walkable, walkable_style(i, line), "zone " + zones[i].id);
  }
  for (const Zone& zone : zones) page.region(zone.obstacles, obstacle_style(line));
}

}  // namespace pedzone
