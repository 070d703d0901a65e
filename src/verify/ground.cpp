#include "verify/ground.hpp"

#include <algorithm>

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

Extent extent_of(const Region& region) {
  Extent extent{region.front().outer.front(), region.front().outer.front()};
  for (const Polygon& polygon : region) {
    for (const Vec2& point : polygon.outer) {
      extent.low = extent.low.cwiseMin(point);
      extent.high = extent.high.cwiseMax(point);
    }
  }
  return extent;
}

Zone zone_of(const Region& walkable, const std::string& model) {
  constexpr double kRim = 1.0;  // [m] numerical: thickness of the outermost walls
  Zone zone;
  zone.id = "verify";
  zone.model = model;
  zone.walkable = walkable;
  const Extent extent = extent_of(walkable);
  zone.obstacles = subtract(repair(box(extent.low.x() - kRim, extent.low.y() - kRim,
                                       extent.high.x() + kRim, extent.high.y() + kRim)),
                            walkable);
  zone.walls = WallIndex(zone.walkable);
  zone.sight_walls = WallIndex(zone.obstacles);
  zone.ways = WayFinder(zone.walkable, kWayClearance);
  return zone;
}

}  // namespace pedzone::verify
