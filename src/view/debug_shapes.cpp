#include "view/debug_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace pedzone {
namespace {

constexpr int kCirclePoints = 32;
constexpr double kLookAhead = 2.0;      // [s] of the chosen speed that a direction is drawn for ...
constexpr double kShortestArrow = 0.3;  // [m] ... or so much, to be seen
constexpr int kPathLayer = 10, kPersonLayer = 20;  // above SUMO's own polygons

/// SUMO refuses ids with characters that mean something in its lists.
std::string as_id(std::string text) {
  for (char& c : text) {
    if (std::string_view(" \t\n\r|\\'\";,<>&").find(c) != std::string_view::npos) c = '_';
  }
  return text;
}

class ShapeFile {
 public:
  void polygon(const std::string& type, const std::string& name, const char* colour, int layer,
               double width, const Polyline& shape) {
    if (shape.size() < 2) return;
    std::string points;
    for (const Vec2& point : shape) {
      fmt::format_to(std::back_inserter(points), "{}{:.2f},{:.2f}", points.empty() ? "" : " ",
                     point.x(), point.y());
    }
    add("    <poly id=\"{0}.{1}\" type=\"{0}\" color=\"{2}\" fill=\"0\" layer=\"{3}\" "
        "lineWidth=\"{4}\" shape=\"{5}\"/>\n",
        type, as_id(name), colour, layer, width, points);
  }

  void point(const std::string& type, const std::string& name, const char* colour, int layer,
             const Vec2& at) {
    add("    <poi id=\"{0}.{1}\" type=\"{0}\" color=\"{2}\" layer=\"{3}\" x=\"{4:.2f}\" "
        "y=\"{5:.2f}\"/>\n",
        type, as_id(name), colour, layer, at.x(), at.y());
  }

  std::string text() const {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<!-- What pedzone's people are about to do. sumo-gui: \"additional-files\". -->\n"
           "<additional>\n" +
           body_ + "</additional>\n";
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(body_), format, std::forward<Values>(values)...);
  }

  std::string body_;
};

Polyline circle(const Waypoint& waypoint) {
  Polyline points;
  for (int k = 0; k <= kCirclePoints; ++k) {
    points.push_back(waypoint.at + waypoint.radius * unit(2.0 * kPi * k / kCirclePoints));
  }
  return points;
}

/// As people would walk if every radius were 0; straight where there is no way.
Polyline way_along(const Zone& zone, const std::vector<PathStop>& stops) {
  Polyline line;
  for (const PathStop& stop : stops) {
    const Vec2& at = stop.waypoint.at;
    if (const auto way = line.empty() ? std::nullopt : zone.ways.way(line.back(), at)) {
      line.insert(line.end(), way->begin(), way->end());
    }
    line.push_back(at);
  }
  return line;
}

void draw_path(const Zone& zone, const WaypointPath& path, const std::vector<PathStop>& stops,
               ShapeFile& file) {
  const std::string name = path.id + "." + zone.id;
  file.polygon("pedzone.debug.path", name, "220,120,220", kPathLayer, 0.1, way_along(zone, stops));
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const std::string stop = fmt::format("{}.{}.{}", name, k + 1, stops[k].poi);
    file.point("pedzone.debug.waypoint", stop, "200,0,200", kPathLayer, stops[k].waypoint.at);
    file.polygon("pedzone.debug.radius", stop, "200,0,200", kPathLayer, 0.1,
                 circle(stops[k].waypoint));
  }
}

/// Out along each ray and back, as one line.
Polyline star(const Insight& insight) {
  Polyline line;
  for (const Ray& ray : insight.rays) {
    line.push_back(insight.position);
    line.push_back(insight.position + ray.free_distance * unit(ray.direction));
  }
  line.push_back(insight.position);
  return line;
}

void draw_person(const DebuggedPerson& person, ShapeFile& file) {
  const Insight& insight = person.insight;
  const double ahead = std::max(kShortestArrow, kLookAhead * insight.speed);
  file.polygon("pedzone.debug.rays", person.id, "150,190,150", kPersonLayer, 0.02, star(insight));
  file.polygon("pedzone.debug.aim", person.id, "0,90,220", kPersonLayer + 1, 0.05,
               {insight.position, insight.aim});
  file.point("pedzone.debug.aim", person.id, "0,90,220", kPersonLayer + 1, insight.aim);
  file.polygon("pedzone.debug.direction", person.id, "220,60,0", kPersonLayer + 2, 0.15,
               {insight.position, insight.position + ahead * unit(insight.direction)});
}

}  // namespace

std::string debug_shapes(const std::vector<Zone>& zones, const std::vector<WaypointPath>& paths,
                         const std::vector<DebuggedPerson>& persons) {
  ShapeFile file;
  for (const WaypointPath& path : paths) {
    for (std::size_t z = 0; z < zones.size(); ++z) draw_path(zones[z], path, path.stops[z], file);
  }
  for (const DebuggedPerson& person : persons) draw_person(person, file);
  return file.text();
}

}  // namespace pedzone
