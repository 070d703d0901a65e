#include "sumo/files/net_reader.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "core/xml.hpp"
#include "sumo/files/geo_reader.hpp"
#include "sumo/files/poi_reader.hpp"

namespace pedzone {
namespace {

constexpr NumberRange kSpeedRange{0.0, 1000.0};         // [m/s]
constexpr NumberRange kWidthRange{0.0, 1000.0};         // [m]
constexpr NumberRange kLengthRange{0.0, 1.0e6};         // [m]
constexpr NumberRange kCoordinateRange{-1.0e8, 1.0e8};  // [m] what geometry/overlay.hpp can hold
constexpr NumberRange kLaneNumberRange{0.0, 1000.0};
constexpr const char* kPersonClass = "pedestrian";

constexpr std::array<std::string_view, 13> kOffRoadClasses{
    "pedestrian", "wheelchair", "tram",      "rail_urban", "rail",     "rail_electric", "rail_fast",
    "light_rail", "subway",     "cable_car", "ship",       "aircraft", "drone"};

bool among(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void read_permissions(const pugi::xml_node& node, Lane& lane) {
  const auto allowed = split_words(node.attribute("allow").value());
  if (!allowed.empty()) {
    const bool all = among(allowed, "all");
    lane.persons = all || among(allowed, kPersonClass);
    lane.vehicles = all || std::any_of(allowed.begin(), allowed.end(), [](const auto& name) {
                      return !among(kOffRoadClasses, name);
                    });
    lane.road_classes = all ? kAllRoadClasses : 0;
    for (const auto& name : allowed) lane.road_classes |= road_class(name);
    return;
  }
  const auto forbidden = split_words(node.attribute("disallow").value());
  const bool all = among(forbidden, "all");
  lane.persons = !all && !among(forbidden, kPersonClass);
  for (const auto& name : forbidden) lane.road_classes &= ~road_class(name);
  lane.vehicles = !all && lane.road_classes != 0;
  lane.persons_only_by_default = lane.persons;
}

/// Points "x,y" or "x,y,z" separated by spaces. Heights go to `z` when any point has one; SUMO
/// leaves out those that are 0.
Polyline read_shape(const XmlFile& file, const pugi::xml_node& node, std::vector<double>* z) {
  Polyline shape;
  std::vector<double> heights;
  bool has_heights = false;
  for (const std::string& word : split_words(node.attribute("shape").value())) {
    const auto parts = split_words(word, ',');
    std::array<double, 3> number{};
    bool good = parts.size() == 2 || parts.size() == 3;
    for (std::size_t i = 0; good && i < parts.size(); ++i) {
      good = parse_number(parts[i], number[i]) && number[i] >= kCoordinateRange.least &&
             number[i] <= kCoordinateRange.most;
    }
    if (!good) {
      throw file.error("is not a point", node, "shape", word,
                       "points \"x,y\" or \"x,y,z\" in metres, at most 1e8, separated by spaces");
    }
    shape.emplace_back(number[0], number[1]);
    heights.push_back(number[2]);
    has_heights |= parts.size() == 3;
  }
  if (z && has_heights) *z = std::move(heights);
  return shape;
}

EdgeFunction read_function(const pugi::xml_node& node) {
  const std::string_view name = node.attribute("function").value();
  if (name == "internal") return EdgeFunction::kInternal;
  if (name == "crossing") return EdgeFunction::kCrossing;
  if (name == "walkingarea") return EdgeFunction::kWalkingArea;
  return EdgeFunction::kNormal;
}

/// Fills a Network from the parsed file, kind of element by kind of element.
class NetworkReader {
 public:
  NetworkReader(const XmlFile& file, Network& network) : file_(file), network_(network) {}

  void read() {
    const pugi::xml_node root = file_.root();
    for (const pugi::xml_node& node : root.children("edge")) read_edge(node);
    for (const auto& [lane, opposite] : opposites_) {
      const auto found = network_.lane_index.find(opposite);
      if (found != network_.lane_index.end()) network_.lanes[lane].opposite = found->second;
    }
    for (const pugi::xml_node& node : root.children("junction")) read_junction(node);
    mark_street_ends();
    for (const pugi::xml_node& node : root.children("connection")) read_connection(node);
    for (const pugi::xml_node& node : root.children("junction")) read_right_of_way(node);
    for (const Connection& connection : network_.connections) share_right_of_way(connection);
  }

 private:
  void read_edge(const pugi::xml_node& node) {
    const int index = static_cast<int>(network_.edges.size());
    Edge edge;
    edge.id = file_.required(node, "id");
    edge.type = node.attribute("type").value();
    edge.function = read_function(node);
    edge.from = node.attribute("from").value();
    edge.to = node.attribute("to").value();
    edge.crossed = split_words(node.attribute("crossingEdges").value());
    edge.line = file_.line(node);
    for (const pugi::xml_node& child : node.children("lane")) {
      edge.lanes.push_back(read_lane(child, index, edge.function));
    }
    if (edge.lanes.empty()) throw file_.error("has no <lane>", node);
    if (!network_.edge_index.emplace(edge.id, index).second) {
      throw file_.error("is used twice", node, "id", edge.id);
    }
    network_.edges.push_back(std::move(edge));
  }

  int read_lane(const pugi::xml_node& node, int edge, EdgeFunction function) {
    const int index = static_cast<int>(network_.lanes.size());
    Lane lane;
    lane.id = file_.required(node, "id");
    lane.edge = edge;
    lane.outline = function == EdgeFunction::kWalkingArea;
    lane.speed = file_.number(node, "speed", kSpeedRange);
    lane.length = file_.number(node, "length", kLengthRange);
    lane.width = file_.number(node, "width", kWidthRange, lane.width);
    read_permissions(node, lane);
    if (const auto beside = node.child("neigh")) {
      opposites_.emplace_back(index, beside.attribute("lane").value());
    }
    file_.required(node, "shape");
    lane.shape = read_shape(file_, node, &lane.z);
    if (lane.shape.size() < 2 && !lane.outline) {
      throw file_.error("is no line", node, "shape", node.attribute("shape").value(),
                        "two points or more");
    }
    if (!network_.lane_index.emplace(lane.id, index).second) {
      throw file_.error("is used twice", node, "id", lane.id);
    }
    network_.lanes.push_back(std::move(lane));
    return index;
  }

  void read_junction(const pugi::xml_node& node) {
    Junction junction;
    junction.id = file_.required(node, "id");
    junction.type = node.attribute("type").value();
    if (junction.type == "internal") return;  // a waiting place inside another junction
    junction.shape = read_shape(file_, node, nullptr);
    network_.junction_index.emplace(junction.id, static_cast<int>(network_.junctions.size()));
    network_.junctions.push_back(std::move(junction));
  }

  void mark_street_ends() {
    std::map<std::string, std::set<std::string>> beyond;  // of a junction: the others' ids
    std::set<std::string> with_carriageway;
    for (int index = 0; index < static_cast<int>(network_.edges.size()); ++index) {
      const Edge& edge = network_.edges[index];
      if (edge.function != EdgeFunction::kNormal) continue;
      beyond[edge.from].insert(edge.to);
      beyond[edge.to].insert(edge.from);
      if (has_carriageway(network_, index)) with_carriageway.insert({edge.from, edge.to});
    }
    for (Junction& junction : network_.junctions) {
      junction.street_end =
          with_carriageway.contains(junction.id) && beyond.at(junction.id).size() == 1;
    }
  }

  void read_connection(const pugi::xml_node& node) {
    Connection connection;
    connection.from = lane_of(node, "from", "fromLane");
    connection.to = lane_of(node, "to", "toLane");
    if (const auto via = network_.lane_index.find(node.attribute("via").value());
        via != network_.lane_index.end()) {
      connection.via = via->second;
    }
    if (!node.attribute("tl").empty()) {
      for (const int lane : {connection.from, connection.to}) {
        Edge& edge = network_.edges[network_.lanes[lane].edge];
        if (edge.function == EdgeFunction::kCrossing) edge.signalled = true;
      }
    }
    Edge& entered = network_.edges[network_.lanes[connection.to].edge];
    if (entered.function == EdgeFunction::kCrossing) {
      entered.priority = std::string_view(node.attribute("state").value()) == "M";
    }
    network_.connections.push_back(connection);
  }

  /// Which vehicles give way to people on a crossing: bit k of a link's response, counted from the
  /// right, is set where it yields to link k.
  void read_right_of_way(const pugi::xml_node& junction) {
    std::vector<int> links;
    for (const std::string& id : split_words(junction.attribute("intLanes").value())) {
      const auto found = network_.lane_index.find(id);
      links.push_back(found == network_.lane_index.end() ? -1 : found->second);
    }
    for (const pugi::xml_node& request : junction.children("request")) {
      const std::size_t own = request.attribute("index").as_uint(~0U);
      const std::string_view response = request.attribute("response").value();
      if (own >= links.size() || links[own] < 0) continue;
      for (std::size_t k = 0; k < std::min(links.size(), response.size()); ++k) {
        if (response[response.size() - 1 - k] != '1' || links[k] < 0) continue;
        const int edge = network_.lanes[links[k]].edge;
        if (network_.edges[edge].function != EdgeFunction::kCrossing) continue;
        network_.lanes[links[own]].yields_at.push_back(edge);
      }
    }
  }

  /// A link with a waiting place inside the junction has two lanes there.
  void share_right_of_way(const Connection& connection) {
    const EdgeFunction from = network_.edges[network_.lanes[connection.from].edge].function;
    if (from != EdgeFunction::kInternal || connection.via < 0) return;
    std::vector<int>& first = network_.lanes[connection.from].yields_at;
    std::vector<int>& second = network_.lanes[connection.via].yields_at;
    first.insert(first.end(), second.begin(), second.end());
    second = first;
  }

  int lane_of(const pugi::xml_node& node, const char* edge_attribute,
              const char* number_attribute) const {
    const std::string id = file_.required(node, edge_attribute);
    const auto edge = network_.edge_index.find(id);
    if (edge == network_.edge_index.end()) {
      throw file_.error("is no edge of the network", node, edge_attribute, id);
    }
    const auto& lanes = network_.edges[edge->second].lanes;
    const double number = file_.number(node, number_attribute, kLaneNumberRange);
    if (number != static_cast<int>(number) || number >= static_cast<double>(lanes.size())) {
      throw file_.error("is no lane of edge '" + id + "'", node, number_attribute,
                        node.attribute(number_attribute).value(),
                        "whole numbers below " + std::to_string(lanes.size()));
    }
    return lanes[static_cast<std::size_t>(number)];
  }

  const XmlFile& file_;
  Network& network_;
  std::vector<std::pair<int, std::string>> opposites_;  ///< of lanes, by id
};

/// Longitudes and latitudes [°] as places [m]; nothing where one of them is no place there.
std::optional<std::vector<Vec2>> on_network(const std::vector<Vec2>& lon_lats, GeoPlaces& earth) {
  std::vector<Vec2> places;
  for (const Vec2& lon_lat : lon_lats) {
    const auto place = earth.at(lon_lat);
    if (!place) return std::nullopt;
    places.push_back(*place);
  }
  return places;
}

void read_polygons(const XmlFile& file, GeoPlaces& earth, Network& network) {
  const auto warn = [&](const pugi::xml_node& node, const std::string& problem) {
    network.warnings.push_back(file.file() + ":" + std::to_string(file.line(node)) + ": polygon '" +
                               node.attribute("id").value() + "' " + problem + ": left out");
  };
  std::unordered_set<std::string> known;
  for (const MapPolygon& polygon : network.polygons) known.insert(polygon.id);
  for (const pugi::xml_node& node : file.root().children("poly")) {
    MapPolygon polygon;
    polygon.id = file.required(node, "id");
    polygon.type = node.attribute("type").value();
    if (!known.insert(polygon.id).second) {
      warn(node, "has the id of another polygon");
      continue;
    }
    polygon.shape = read_shape(file, node, nullptr);
    if (node.attribute("geo").as_bool()) {
      auto places = on_network(polygon.shape, earth);
      if (!places) {
        warn(node,
             "has longitudes and latitudes, and the network's <location> no projection for them");
        continue;
      }
      polygon.shape = std::move(*places);
    }
    if (polygon.shape.size() > 1 && polygon.shape.front() == polygon.shape.back()) {
      polygon.shape.pop_back();
    }
    network.polygons.push_back(std::move(polygon));
  }
}

}  // namespace

Network read_network(const std::string& net_file) {
  const XmlFile file(net_file, {"net"});
  Network network;
  network.file = net_file;
  network.left_hand = file.root().attribute("lefthand").as_bool();
  NetworkReader(file, network).read();
  return network;
}

void read_shapes(const std::string& additional_file, Network& network) {
  const XmlFile file(additional_file);
  GeoPlaces earth(network.file);
  read_polygons(file, earth, network);
  read_waypoints(file, earth, network);
}

}  // namespace pedzone
