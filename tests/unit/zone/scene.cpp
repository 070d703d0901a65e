#include "scene.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace pedzone::test {

Scene& Scene::add(const Street& street) {
  const int edge = static_cast<int>(network_.edges.size());
  const int index = static_cast<int>(network_.lanes.size());
  Lane lane;
  lane.id = street.id + "_0";
  lane.edge = edge;
  lane.speed = street.speed;
  lane.width = street.width;
  for (std::size_t i = 0; i + 1 < street.shape.size(); ++i) {
    lane.length += (street.shape[i + 1] - street.shape[i]).norm();
  }
  lane.persons = street.persons;
  lane.vehicles = street.vehicles;
  lane.persons_only_by_default = street.by_default;
  lane.shape = street.shape;
  lane.z = street.z;
  Edge added;
  added.id = street.id;
  added.type = street.type;
  added.from = street.from.empty() ? street.id + ".from" : street.from;
  added.to = street.to.empty() ? street.id + ".to" : street.to;
  added.lanes = {index};
  network_.edge_index[added.id] = edge;
  network_.lane_index[lane.id] = index;
  network_.edges.push_back(added);
  network_.lanes.push_back(lane);
  return *this;
}

Scene& Scene::add_road(const std::string& id, const Polyline& shape, double width) {
  Street road{id, shape};
  road.type = "highway.residential";
  road.width = width;
  road.speed = 13.89;
  road.persons = false;
  road.vehicles = true;
  return add(road);
}

Scene& Scene::add_polygon(const std::string& id, const std::string& type, const Ring& shape) {
  network_.polygons.push_back({id, type, shape});
  return *this;
}

Scene& Scene::add_building(const std::string& id, const Ring& shape) {
  return add_polygon(id, "building", shape);
}

Zone Scene::zone(const std::vector<ZoneSpec>& specs) const {
  return std::move(build_zones(network_, specs).front());
}

Ring rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

ZoneSpec closed_spec() {
  ZoneSpec spec;
  spec.open_space = 0.0;
  return spec;
}

std::string complaint(const Network& network, const std::vector<ZoneSpec>& specs) {
  try {
    build_zones(network, specs);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> edge_ids(const Network& network, const Zone& zone) {
  std::vector<std::string> ids;
  for (const int edge : zone.edges) ids.push_back(network.edges[edge].id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<std::string> lane_ids(const Network& network, const Zone& zone) {
  std::vector<std::string> ids;
  for (const int lane : zone.lanes) ids.push_back(network.lanes[lane].id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::string data_file(const std::string& name) { return PEDZONE_TEST_DATA "/" + name; }

std::string network_file(const std::string& name) { return PEDZONE_NETWORKS "/" + name; }

}  // namespace pedzone::test
