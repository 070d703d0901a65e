#include "zone/lane_geometry.hpp"

namespace pedzone {

double shape_scale(const Lane& lane) {
  return lane.length > 0.0 ? length_of(lane.shape) / lane.length : 1.0;
}

LinePoint point_on_lane(const Lane& lane, double position) {
  return point_on(lane.shape, position * shape_scale(lane));
}

LineProjection project_on_lane(const Lane& lane, const Vec2& point) {
  LineProjection projection = project_on(lane.shape, point);
  const double shape_length = length_of(lane.shape);
  if (shape_length > 0.0) projection.offset *= lane.length / shape_length;
  return projection;
}

double distance_to_lane(const Lane& lane, const Vec2& point) {
  return (point_on_lane(lane, project_on_lane(lane, point).offset).point - point).norm();
}

}  // namespace pedzone
