#include "sumo/files/poi_reader.hpp"

#include <algorithm>
#include <string_view>

#include "zone/lane_geometry.hpp"

namespace pedzone {
namespace {

constexpr std::string_view kWaypointType = "pedzone.waypoint";
constexpr std::string_view kSeatType = "pedzone.seat";
constexpr std::string_view kOwnKeys = "pedzone.";  // of parameters that are ours
constexpr std::string_view kRadiusKey = "pedzone.radius";
constexpr NumberRange kRadiusRange{0.0, 20.0};          // [m]
constexpr NumberRange kCoordinateRange{-1.0e8, 1.0e8};  // [m] as shapes of the network
constexpr NumberRange kLateralRange{-1000.0, 1000.0};   // [m]
constexpr NumberRange kLongitudeRange{-180.0, 180.0};   // [°]
constexpr NumberRange kLatitudeRange{-90.0, 90.0};      // [°]

Vec2 place_on_lane(const XmlFile& file, const pugi::xml_node& node, const Network& network) {
  const std::string id = file.required(node, "lane");
  const auto found = network.lane_index.find(id);
  if (found == network.lane_index.end() || network.lanes[found->second].outline) {
    throw file.error("is no lane of the network", node, "lane", id);
  }
  const Lane& lane = network.lanes[found->second];
  double position = file.number(node, "pos", {-lane.length, lane.length});
  if (position < 0.0) position += lane.length;
  const double left = file.number(node, "posLat", kLateralRange, 0.0);
  const LinePoint there = point_on_lane(lane, position);
  return there.point + left * Vec2(-there.direction.y(), there.direction.x());
}

Vec2 place_on_earth(const XmlFile& file, const pugi::xml_node& node, GeoPlaces& earth) {
  const Vec2 lon_lat(file.number(node, "lon", kLongitudeRange),
                     file.number(node, "lat", kLatitudeRange));
  const auto place = earth.at(lon_lat);
  if (!place) {
    throw file.error("is a longitude for which the network's <location> has no projection", node,
                     "lon", node.attribute("lon").value(), "x and y, or lane and pos");
  }
  return *place;
}

Vec2 read_place(const XmlFile& file, const pugi::xml_node& node, GeoPlaces& earth,
                const Network& network) {
  if (!node.attribute("lane").empty()) return place_on_lane(file, node, network);
  if (node.attribute("x").empty() && !node.attribute("lon").empty()) {
    return place_on_earth(file, node, earth);
  }
  return {file.number(node, "x", kCoordinateRange), file.number(node, "y", kCoordinateRange)};
}

std::optional<double> read_radius(const XmlFile& file, const pugi::xml_node& node) {
  std::optional<double> radius;
  for (const pugi::xml_node& child : node.children("param")) {
    const std::string key = child.attribute("key").value();
    if (!key.starts_with(kOwnKeys)) continue;  // another program's
    if (key != kRadiusKey) {
      throw file.error("is no parameter of a waypoint", child, "key", key, std::string(kRadiusKey));
    }
    radius = file.number(child, "value", kRadiusRange);
    if (*radius <= 0.0) {
      throw file.error(
          "is out of range", child, "value", child.attribute("value").value(),
          "more than 0, at most " + std::to_string(static_cast<int>(kRadiusRange.most)));
    }
  }
  return radius;
}

}  // namespace

void read_waypoints(const XmlFile& file, GeoPlaces& earth, Network& network) {
  for (const pugi::xml_node& node : file.root().children("poi")) {
    const std::string_view type = node.attribute("type").value();
    if (type == kSeatType) network.seats.push_back(read_place(file, node, earth, network));
    if (type != kWaypointType) continue;
    MapPoint point;
    point.id = file.required(node, "id");
    if (std::ranges::find(network.waypoints, point.id, &MapPoint::id) != network.waypoints.end()) {
      throw file.error("is used twice", node, "id", point.id, "a new id");
    }
    point.at = read_place(file, node, earth, network);
    point.radius = read_radius(file, node);
    network.waypoints.push_back(std::move(point));
  }
}

}  // namespace pedzone
