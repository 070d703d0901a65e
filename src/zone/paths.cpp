#include "zone/paths.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "core/xml.hpp"
#include "zone/zone.hpp"

namespace pedzone {
namespace {

InputError path_error(const PathSpec& spec, const std::string& problem, const std::string& value,
                      const std::string& allowed) {
  return InputError(problem, {spec.file, spec.line,
                              "<path id=\"" + spec.id + "\"> attribute waypoints", value, allowed});
}

/// "a, b, c" of things with an id.
template <class Things>
std::string ids_of(const Things& things) {
  return things.empty() ? "none" : comma_list(things, [](const auto& thing) { return thing.id; });
}

const MapPoint& find_point(const Network& network, const PathSpec& spec, const std::string& id) {
  const auto& points = network.waypoints;
  const auto found = std::ranges::find(points, id, &MapPoint::id);
  if (found == points.end()) {
    throw path_error(spec, "is no POI of type pedzone.waypoint in the scenario's additional files",
                     id, ids_of(points));
  }
  return *found;
}

/// Whether people who walk on the zone's lanes can get there. A yard that only a polygon opens,
/// and that no lane leads to, is inside the zone but out of reach.
bool reached_from_lanes(const Network& network, const Zone& zone, const Vec2& at) {
  return std::ranges::any_of(zone.lanes, [&](int lane) {
    const Polyline& shape = network.lanes[lane].shape;
    return std::ranges::any_of(shape, [&](const Vec2& point) {
      return zone.walls.inside(point) && zone.ways.has_way(at, point);
    });
  });
}

bool reached_from_others(const Zone& zone, const std::vector<PathStop>& stops,
                         const PathStop& stop) {
  const auto other = [&](const PathStop& from) { return from.poi != stop.poi; };
  return std::ranges::none_of(stops, other) ||
         std::ranges::any_of(stops, [&](const PathStop& from) {
           return other(from) && zone.ways.has_way(from.waypoint.at, stop.waypoint.at);
         });
}

void require_ways(const Network& network, const Zone& zone, const PathSpec& spec,
                  const std::vector<PathStop>& stops) {
  for (const PathStop& stop : stops) {
    if (!reached_from_lanes(network, zone, stop.waypoint.at)) {
      throw path_error(spec, "cannot be walked to: walls part it from all lanes of its zone",
                       stop.poi, "waypoints with a way to them inside zone '" + zone.id + "'");
    }
  }
  for (const PathStop& stop : stops) {
    if (!reached_from_others(zone, stops, stop)) {
      throw path_error(spec,
                       "cannot be walked to: walls part it from the other waypoints of the path",
                       stop.poi, "waypoints with a way between them inside zone '" + zone.id + "'");
    }
  }
}

WaypointPath find_stops(const Network& network, const std::vector<Zone>& zones,
                        const PathSpec& spec) {
  WaypointPath path{spec.id, std::vector<std::vector<PathStop>>(zones.size())};
  for (const std::string& id : spec.waypoints) {
    const MapPoint& point = find_point(network, spec, id);
    bool inside = false;
    for (std::size_t z = 0; z < zones.size(); ++z) {
      if (!zones[z].walls.inside(point.at)) continue;
      const double radius = point.radius.value_or(zones[z].parameters.waypoint_radius);
      path.stops[z].push_back({id, {point.at, radius}});
      inside = true;
    }
    if (!inside) {
      throw path_error(spec, "lies outside every zone", id,
                       "waypoints in the walkable area of a zone: " + ids_of(zones));
    }
  }
  for (std::size_t z = 0; z < zones.size(); ++z) {
    require_ways(network, zones[z], spec, path.stops[z]);
  }
  return path;
}

}  // namespace

std::vector<Waypoint> WaypointPath::waypoints(std::size_t zone) const {
  std::vector<Waypoint> list;
  for (const PathStop& stop : stops[zone]) list.push_back(stop.waypoint);
  return list;
}

PathSpec read_path(const XmlFile& file, const pugi::xml_node& node) {
  file.check_names(node, {"id", "waypoints"}, {});
  PathSpec spec;
  spec.id = file.required(node, "id");
  spec.waypoints = split_words(file.required(node, "waypoints"));
  spec.file = file.file();
  spec.line = file.line(node);
  if (spec.waypoints.empty()) {
    throw file.error("is empty", node, "waypoints", "", "ids of POIs of type pedzone.waypoint");
  }
  const auto twice = std::ranges::adjacent_find(spec.waypoints);
  if (twice != spec.waypoints.end()) {
    throw file.error("is named twice in a row", node, "waypoints", *twice,
                     "another waypoint between");
  }
  return spec;
}

std::vector<WaypointPath> find_paths(const Network& network, const std::vector<Zone>& zones,
                                     const std::vector<PathSpec>& specs) {
  std::vector<WaypointPath> paths;
  for (const PathSpec& spec : specs) paths.push_back(find_stops(network, zones, spec));
  return paths;
}

const WaypointPath* find_path(const std::vector<WaypointPath>& paths, const std::string& id) {
  const auto found = std::ranges::find(paths, id, &WaypointPath::id);
  return found == paths.end() ? nullptr : &*found;
}

std::string path_ids(const std::vector<WaypointPath>& paths) { return ids_of(paths); }

}  // namespace pedzone
