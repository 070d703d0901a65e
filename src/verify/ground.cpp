#include "verify/ground.hpp"

#include "zone/shapes.hpp"

namespace pedzone::verify {

Ring box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Region joined(std::initializer_list<Ring> rings) {
  Region all;
  for (const Ring& ring : rings) all = unite(all, repair(ring));
  return all;
}

Vec2 turned(const Vec2& point, double angle) {
  const Vec2 e = unit(angle);
  return point.x() * e + point.y() * left_of(e);
}

Region turned(const Region& region, double angle) {
  Region result = region;
  for (Polygon& polygon : result) {
    for (Vec2& point : polygon.outer) point = turned(point, angle);
    for (Ring& hole : polygon.holes) {
      for (Vec2& point : hole) point = turned(point, angle);
    }
  }
  return result;
}

Zone zone_of(const Region& walkable, const std::string& model) {
  constexpr double kRim = 1.0;  // [m] numerical: thickness of the outermost walls
  Zone zone;
  zone.id = "verify";
  zone.model = model;
  zone.walkable = walkable;
  const Box rim = grown(box_of(walkable), kRim);
  const Ring around = box(rim.min().x(), rim.min().y(), rim.max().x(), rim.max().y());
  zone.obstacles = subtract(repair(around), walkable);
  zone.walls = WallIndex(zone.walkable);
  zone.sight_walls = WallIndex(zone.obstacles);
  zone.ways = WayFinder(zone.walkable, kWayClearance);
  return zone;
}

}  // namespace pedzone::verify
