#include "view/zone_svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pages/palette.hpp"
#include "view/map_panel.hpp"
#include "view/zone_map.hpp"

namespace pedzone {
namespace {

constexpr double kMargin = 25.0;  // [m] shown round the zones

constexpr std::string_view kSharedLaneColour = colours::kVermilion.light;
constexpr std::string_view kFootLaneColour = colours::kGreen.light;

Box extent(const Network& network, const std::vector<Zone>& zones) {
  Box box;
  for (const Zone& zone : zones) box.extend(box_of(zone.walkable));
  if (box.isEmpty()) {
    for (const Lane& lane : network.lanes) box.extend(box_of(lane.shape));
  }
  return grown(box, kMargin);
}

std::vector<LegendEntry> legend(const std::vector<Zone>& zones,
                                const std::vector<PathLayer>& layers) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    entries.push_back(area_entry(
        fmt::format("walkable, zone \"{}\" ({:.0f} m²)", zones[i].id, area(zones[i].walkable)),
        walkable_style(i)));
  }
  entries.push_back(area_entry("obstacle (building ...)", obstacle_style()));
  entries.push_back(
      line_entry("lane in a zone, persons and vehicles", stroke(kSharedLaneColour, 0.5)));
  entries.push_back(line_entry("lane in a zone, persons only", stroke(kFootLaneColour, 0.5)));
  entries.push_back(line_entry("road that stays SUMO's", stroke(colours::kRoad.light, 3.0)));
  entries.push_back(line_entry("footway that stays SUMO's", stroke(colours::kFootway.light, 2.0)));
  for (const PathLayer& layer : layers) {
    entries.push_back(line_entry(fmt::format("{} ({})", layer.name, layer.lines.size()),
                                 stroke(layer.colour, layer.width)));
  }
  return entries;
}

void draw_lanes(SvgPage& page, const Network& network, const Zone& zone, double width) {
  page.begin_group("stroke-opacity=\"0.7\"");
  for (const int index : zone.lanes) {
    const Lane& lane = network.lanes[index];
    const Edge& edge = network.edges[lane.edge];
    if (lane.outline || edge.function == EdgeFunction::kInternal) continue;
    page.line(lane.shape, stroke(lane.vehicles ? kSharedLaneColour : kFootLaneColour, width),
              lane.id + " " + edge.type);
  }
  page.end_group();
}

void draw_layer(SvgPage& page, const PathLayer& layer) {
  page.begin_group(
      fmt::format("{} stroke-opacity=\"{:.3f}\" stroke-linejoin=\"round\" stroke-linecap=\"round\"",
                  stroke(layer.colour, layer.width), layer.opacity));
  for (const Polyline& line : layer.lines) page.line(line, "");
  page.end_group();
}

}  // namespace

std::string zone_svg(const Network& network, const std::vector<Zone>& zones,
                     const std::vector<PathLayer>& layers) {
  const Box box = extent(network, zones);
  const MapPanel panel(box.sizes(), legend(zones, layers), false);
  SvgPage page(box, panel.height());
  draw_zone_map(page, network, zones);
  const double lane_width = std::max(0.3, 0.08 * panel.unit());  // to be seen in large pictures too
  for (const Zone& zone : zones) draw_lanes(page, network, zone, lane_width);
  for (const PathLayer& layer : layers) draw_layer(page, layer);
  panel.draw(page);
  return page.finish("Zones of " + network.file);
}

}  // namespace pedzone
