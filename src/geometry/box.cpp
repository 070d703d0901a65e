#include "geometry/box.hpp"

namespace pedzone {

Box box_of(const Polyline& points) {
  Box box;
  for (const Vec2& point : points) box.extend(point);
  return box;
}

Box box_of(const Region& region) {
  Box box;
  for (const Polygon& polygon : region) box.extend(box_of(polygon.outer));
  return box;
}

Box grown(const Box& box, double distance) {
  if (box.isEmpty()) return box;
  const Vec2 margin(distance, distance);
  return {box.min() - margin, box.max() + margin};
}

}  // namespace pedzone
