#include <fmt/format.h>

#include <iterator>
#include <set>
#include <unordered_set>

#include "core/text.hpp"
#include "view/animation_parts.hpp"
#include "view/road_look.hpp"
#include "view/street_names.hpp"

namespace pedzone::animation {
namespace {

constexpr double kSurroundings = 50.0;  // [m] so far around the box the ground is shown

/// Elements of a JSON array, one after the other.
class List {
 public:
  template <class... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    if (!text_.empty()) text_ += ',';
    fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
  }
  std::string text() const { return '[' + text_ + ']'; }

 private:
  std::string text_;
};

std::string points(const std::vector<Vec2>& line) {
  List list;
  for (const Vec2& point : line) {
    list.add("{},{}", centimetres(point.x()), centimetres(point.y()));
  }
  return list.text();
}

/// Polygons that reach into the box.
void add_region(List& polygons, const Region& region, const Box& box) {
  for (const Polygon& polygon : region) {
    if (!box.intersects(box_of(polygon.outer))) continue;
    List rings;
    rings.add("{}", points(polygon.outer));
    for (const Ring& hole : polygon.holes) rings.add("{}", points(hole));
    polygons.add("{}", rings.text());
  }
}

struct Roads {
  List junctions, roads, footways, footareas;
};

Roads roads_near(const Place& place, const Box& box) {
  std::unordered_set<int> inside;
  for (const Zone& zone : place.zones) inside.insert(zone.lanes.begin(), zone.lanes.end());
  const Network& network = place.network;
  Roads roads;
  for (int index = 0; index < static_cast<int>(network.lanes.size()); ++index) {
    const Lane& lane = network.lanes[index];
    if (inside.contains(index) || !box.intersects(box_of(lane))) continue;
    const RoadLook look = look_of(network, lane);
    if (look == RoadLook::kHidden) continue;
    if (look == RoadLook::kFootArea) {
      roads.footareas.add("{}", points(lane.shape));
    } else {
      (look == RoadLook::kRoad ? roads.roads : roads.footways)
          .add(R"({{"width":{},"points":{}}})", centimetres(lane.width), points(lane.shape));
    }
  }
  for (const Junction& junction : network.junctions) {
    if (box.intersects(box_of(junction.shape))) {
      roads.junctions.add("{}", points(junction.shape));
    }
  }
  return roads;
}

std::string waypoints(const std::vector<WaypointPath>& paths) {
  List list;
  std::set<std::string> known;
  for (const WaypointPath& path : paths) {
    for (const std::vector<PathStop>& stops : path.stops) {
      for (const auto& [poi, waypoint] : stops) {
        if (!known.insert(poi).second) continue;
        list.add(R"({{"x":{:.2f},"y":{:.2f},"radius":{:.2f}}})", waypoint.at.x(), waypoint.at.y(),
                 waypoint.radius);
      }
    }
  }
  return list.text();
}

}  // namespace

std::string scenery(const Place* place, const Box& box) {
  Roads roads;
  List zone, obstacles, streets;
  std::string stops = "[]";
  if (place != nullptr) {
    const Box seen = grown(box, kSurroundings);
    roads = roads_near(*place, seen);
    for (const Zone& one : place->zones) {
      add_region(zone, one.walkable, seen);
      add_region(obstacles, one.obstacles, seen);
    }
    stops = waypoints(place->paths);
    for (const NamedStreet& street : named_streets(*place, seen)) {
      streets.add(R"({{"name":{},"points":{}}})", json_string(street.name), points(street.line));
    }
  }
  return fmt::format(
      R"({{"junctions":{},"roads":{},"footways":{},"footareas":{},"zone":{},"obstacles":{},)"
      R"("waypoints":{},"streets":{}}})",
      roads.junctions.text(), roads.roads.text(), roads.footways.text(), roads.footareas.text(),
      zone.text(), obstacles.text(), stops, streets.text());
}

}  // namespace pedzone::animation
