// Places on lines: how far along, how far to the side.
#pragma once

#include <optional>
#include <span>

#include "core/vec.hpp"

namespace pedzone {

/// Length of a line [m].
double length_of(std::span<const Vec2> line);

/// A point on a line and the direction there.
struct LinePoint {
  Vec2 point;      ///< [m]
  Vec2 direction;  ///< unit vector along the line
};

/// The point at `offset` [m] along a line, clamped to its ends.
LinePoint point_on(std::span<const Vec2> line, double offset);

/// The same for offsets that do not fall, each from where the last one was.
class LineWalk {
 public:
  explicit LineWalk(std::span<const Vec2> line);
  LinePoint to(double offset);

 private:
  std::span<const Vec2> line_;
  LinePoint last_;
  std::size_t next_ = 1;  ///< the end of the piece that comes next
  double passed_ = 0.0;   ///< [m] along the line, of where it begins
};

/// Makes the place at `offset` [m] along a line one of its points. Beyond its ends nothing is done.
void insert_point(double offset, Polyline& line);

/// Where a point projects on a line.
struct LineProjection {
  double offset;   ///< [m] along the line, of the nearest point
  double lateral;  ///< [m] signed distance, positive to the left
};
LineProjection project_on(std::span<const Vec2> line, const Vec2& point);

/// Where a line comes near a point, and where it leaves it for good: of one that turns back, the
/// nearest point may be on either leg.
struct LineStretch {
  double first, last;  ///< [m] along the line
};

/// The first and the last place on a line at most `distance` [m] ≥ 0 from a point; nothing where
/// there is none.
std::optional<LineStretch> stretch_within(std::span<const Vec2> line, const Vec2& point,
                                          double distance);

/// [m] by which a chord between two points that are `length` [m] apart along the line leaves it at
/// most: a bound by all that it turns. The chord is shorter than that by at most twice as much.
double most_cut(std::span<const Vec2> line, double length);

}  // namespace pedzone
