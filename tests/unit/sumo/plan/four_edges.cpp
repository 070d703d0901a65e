#include "four_edges.hpp"

namespace pedzone::test {

FourEdges::FourEdges() {
  e0 = add_edge("e0", "A", "B", 0, 50);
  e1 = add_edge("e1", "B", "C", 50, 100);
  e2 = add_edge("e2", "C", "D", 100, 150);
  e3 = add_edge("e3", "D", "E", 150, 200);
  zone.id = "street";
  zone.edges = {e1, e2};
  zone.lanes = {lane_of(e1), lane_of(e2)};
  link(e1, e2);
  connect(lane_of(e0), lane_of(e1));
  connect(lane_of(e1), lane_of(e2));
  connect(lane_of(e2), lane_of(e3));
  zone.walkable = Region{Polygon{{{50, -2}, {150, -2}, {150, 2}, {50, 2}}, {}}};
  zone.walls = WallIndex(zone.walkable);
  zone.ways = WayFinder(zone.walkable, kWayClearance);
}

int FourEdges::add_edge(const std::string& id, const std::string& from, const std::string& to,
                        double begin, double end, int lanes) {
  const int edge = static_cast<int>(network.edges.size());
  Edge added;
  added.id = id;
  added.from = from;
  added.to = to;
  for (int i = 0; i < lanes; ++i) {
    Lane lane;
    lane.id = id + "_" + std::to_string(i);
    lane.edge = edge;
    lane.width = 4.0;
    lane.length = std::abs(end - begin);
    lane.persons = i == 0;
    lane.vehicles = true;
    lane.shape = {{begin, 4.0 * i}, {end, 4.0 * i}};
    added.lanes.push_back(static_cast<int>(network.lanes.size()));
    network.lane_index[lane.id] = added.lanes.back();
    network.lanes.push_back(lane);
  }
  network.edges.push_back(added);
  network.edge_index[id] = edge;
  return edge;
}

void FourEdges::link(int a, int b) { zone.links[{std::min(a, b), std::max(a, b)}]; }

void FourEdges::has_space(const Ring& outline) {
  const Region space{Polygon{outline, {}}};
  zone.walls = WallIndex(space);
  zone.ways = WayFinder(space, kWayClearance);
}

void FourEdges::put_walking_area_between(int before, int after) {
  const double x = network.lanes[lane_of(before)].shape.back().x();
  const int area = add_edge(":" + network.edges[before].to + "_w0", "", "", x, x + 2.0);
  network.edges[area].function = EdgeFunction::kWalkingArea;
  connect(lane_of(before), lane_of(area));
  connect(lane_of(area), lane_of(after));
}

int FourEdges::add_walking_area() {
  put_walking_area_between(e2, e3);
  network.lanes[lane_of(e3)].shape.front().x() = 152.0;
  has_space({{50, -2}, {152, -2}, {152, 2}, {50, 2}});
  return add_edge("e4", "E", "F", 200, 250);
}

void FourEdges::connect(int from_lane, int to_lane) {
  network.connections.push_back({from_lane, to_lane});
}

VehicleSeen seen_vehicle(const std::string& id, const Vec2& front, double speed) {
  VehicleSeen vehicle;
  vehicle.id = id;
  vehicle.traits.length = 4.0;
  vehicle.traits.width = 2.0;
  vehicle.front = front;
  vehicle.speed = speed;
  vehicle.allowed_speed = 30.0;
  return vehicle;
}

}  // namespace pedzone::test
