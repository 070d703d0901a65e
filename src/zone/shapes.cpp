#include "zone/shapes.hpp"

#include <algorithm>

namespace pedzone {

Region area_of(const Lane& lane) {
  // Only walking areas have an outline; it has three points at least where it is an area at all.
  if (lane.outline) return repair(lane.shape);
  return widen(lane.shape, std::max(lane.width, kLeastLaneWidth));
}

Box box_of(const Lane& lane) {
  return grown(box_of(lane.shape),
               lane.outline ? 0.0 : 0.5 * std::max(lane.width, kLeastLaneWidth));
}

double nearest_part(const Vec2& a, const Vec2& b, const Vec2& point) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  return squared > 0.0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0.0;
}

Vec2 inner_point(const Polyline& line, bool at_end, double inset) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += (line[i + 1] - line[i]).norm();
  double left = std::min(inset, 0.5 * length);
  if (at_end) left = length - left;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double piece = (line[i + 1] - line[i]).norm();
    if (left <= piece && piece > 0.0) return line[i] + (line[i + 1] - line[i]) * (left / piece);
    left -= piece;
  }
  return line.back();
}

}  // namespace pedzone
