#include "zone/zone.hpp"

#include <algorithm>

#include "zone/levels.hpp"
#include "zone/road_overlaps.hpp"
#include "zone/selection.hpp"
#include "zone/walkable_area.hpp"

namespace pedzone {
namespace {

/// A zone that is being built.
struct Draft {
  const ZoneSpec* spec = nullptr;
  ZoneParts parts;
  std::vector<std::string> warnings;
};

/// Edges that a zone names, and another one has.
void warn_of_taken(const Network& network, const std::vector<bool>& taken, Draft& draft) {
  for (const std::string& id : draft.spec->edges) {
    const auto edge = network.edge_index.find(id);
    if (edge == network.edge_index.end() || !taken[edge->second]) continue;
    draft.warnings.push_back("edge '" + id + "' belongs to the zone before it that names it, too");
  }
}

/// Zones that name edges choose before those that take what is left; among equals the first.
void select_all(const Network& network, const RoadOverlaps& roads, std::vector<Draft>& drafts,
                std::vector<bool>& taken) {
  for (const bool automatic : {false, true}) {
    for (Draft& draft : drafts) {
      if (draft.spec->automatic() != automatic) continue;
      Selection& selection = draft.parts.selection;
      warn_of_taken(network, taken, draft);
      selection = select_lanes(network, *draft.spec, taken);
      separate_levels(network, selection, draft.warnings);
      roads.leave_out_covered(*draft.spec, selection, draft.warnings);
      for (const int edge : selection.edges) taken[edge] = true;
    }
  }
}

/// Adds the streets that people may cross anywhere.
void add_streets(const Network& network, const Draft& draft, Zone& zone) {
  if (draft.spec->crossing != CrossingRule::kAnywhere) return;
  const Selection& selection = draft.parts.selection;
  zone.streets = find_streets(network, selection.edges, selection.lanes, zone.walkable);
  if (zone.streets.empty()) {
    zone.warnings.push_back(
        "crossing=\"anywhere\" changes nothing: none of the zone's streets has "
        "ground for people on both sides");
    return;
  }
  for (const auto& link : linked_across(network, zone.streets, selection.edges)) {
    zone.links[link].clear();
  }
  zone.crossable = subtract(crossable_ground(zone.streets), zone.obstacles);
  zone.street_walls = WallIndex(unite(zone.walkable, zone.crossable));
}

std::vector<Region> shades_of(const Network& network) {
  std::vector<Region> shades;
  for (const MapPolygon& polygon : network.polygons) {
    if (polygon.type == "pedzone.shade") shades.push_back(repair(polygon.shape));
  }
  std::erase_if(shades, [](const Region& shade) { return shade.empty(); });
  return shades;
}

Zone finish(const Network& network, const RoadOverlaps& roads, const std::vector<bool>& taken,
            Draft& draft) {
  ZoneParts& parts = draft.parts;
  roads.warn(parts.selection, draft.warnings);
  parts.links = find_links(network, parts.selection.edges);
  parts.inner_lanes = inner_lanes(network, parts.selection.lanes, parts.links);
  parts.shared_junctions = shared_junctions(network, parts.selection.edges);
  WalkableArea area = build_walkable_area(network, *draft.spec, parts, taken, draft.warnings);

  Zone zone;
  zone.id = draft.spec->id;
  zone.parameters = draft.spec->parameters;
  zone.model = draft.spec->model;
  zone.weather = draft.spec->weather;
  zone.edges.insert(parts.selection.edges.begin(), parts.selection.edges.end());
  for (const Link& link : parts.links) zone.links[{link.from, link.to}].insert(link.junction);
  std::merge(parts.selection.lanes.begin(), parts.selection.lanes.end(), parts.inner_lanes.begin(),
             parts.inner_lanes.end(), std::back_inserter(zone.lanes));
  zone.walkable = std::move(area.walkable);
  zone.obstacles = std::move(area.obstacles);
  zone.walls = WallIndex(zone.walkable);
  zone.sight_walls = WallIndex(zone.obstacles);
  std::ranges::copy_if(network.seats, std::back_inserter(zone.seats),
                       [&](const Vec2& seat) { return zone.walls.inside(seat); });
  if (zone.weather->shade) zone.shades = shades_of(network);
  zone.ways = WayFinder(zone.walkable, kWayClearance);
  zone.crosswalks = Crosswalks(find_crosswalks(network, zone.lanes));
  zone.warnings = std::move(draft.warnings);
  add_streets(network, draft, zone);
  zone.inside = lengths_inside(network, parts.selection.edges);
  zone.left_out = lengths_left_out(network, taken);
  return zone;
}

}  // namespace

bool linked(const Zone& zone, int edge, int other) {
  return zone.links.contains({std::min(edge, other), std::max(edge, other)});
}

bool linked(const Zone& zone, int edge, int other, const std::string& junction) {
  const auto found = zone.links.find({std::min(edge, other), std::max(edge, other)});
  return found != zone.links.end() && (found->second.empty() || found->second.contains(junction));
}

std::vector<Zone> build_zones(const Network& network, const std::vector<ZoneSpec>& specs) {
  const ZoneSpec by_rule;
  std::vector<Draft> drafts;
  for (const ZoneSpec& spec : specs) drafts.push_back({&spec, {}, {}});
  if (drafts.empty()) drafts.push_back({&by_rule, {}, {}});
  std::vector<bool> taken(network.edges.size(), false);
  const RoadOverlaps roads(network);
  select_all(network, roads, drafts, taken);
  std::vector<Zone> zones;
  for (Draft& draft : drafts) zones.push_back(finish(network, roads, taken, draft));
  return zones;
}

}  // namespace pedzone
