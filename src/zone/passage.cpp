#include "zone/passage.hpp"

#include <limits>
#include <utility>

namespace pedzone {
namespace {

double distance_to(const Ring& ring, const Vec2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 foot = ring[j] + (ring[i] - ring[j]) * nearest_part(ring[j], ring[i], point);
    least = std::min(least, (point - foot).norm());
  }
  return least;
}

double distance_to(const Polygon& polygon, const Vec2& point) {
  if (contains({polygon}, point)) return 0.0;
  double least = distance_to(polygon.outer, point);
  for (const Ring& hole : polygon.holes) least = std::min(least, distance_to(hole, point));
  return least;
}

constexpr double kAround = 1.0;  // [m] numerical: where a ring is cut nothing is decided

/// What is left of a ring on one side of a line along an axis (Sutherland and Hodgman 1974): its
/// pieces hang together by edges to and fro along that line.
Ring cut(const Ring& ring, int axis, double at, double side) {
  Ring kept;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const double a = side * (ring[j][axis] - at), b = side * (ring[i][axis] - at);
    if ((a < 0.0) != (b < 0.0)) kept.push_back(ring[j] + (ring[i] - ring[j]) * (a / (a - b)));
    if (b >= 0.0) kept.push_back(ring[i]);
  }
  return kept;
}

/// What is left of a ring in a box; empty: nothing.
Ring cut(const Ring& ring, const Box& box) {
  const Box own = box_of(ring);
  if (!box.intersects(own)) return {};
  if (box.contains(own)) return ring;
  Ring left = ring;
  for (const int axis : {0, 1}) {
    left = cut(left, axis, box.min()[axis], 1.0);
    if (!left.empty()) left = cut(left, axis, box.max()[axis], -1.0);
    if (left.empty()) break;
  }
  return left;
}

}  // namespace

Passages::Passages(const Region& area, double room)
    : parts_(grow(area, -room, Corners::kMitred)), room_(room) {
  for (const Polygon& part : parts_) boxes_.push_back(grown(box_of(part.outer), room));
}

int Passages::part_of(const Vec2& place) const {
  // A little more than the room: the shrunk border has its own rounding.
  double least = room_ * 1.5;
  int best = -1;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!grown(boxes_[i], 0.5 * room_).contains(place)) continue;
    const double distance = distance_to(parts_[i], place);
    if (distance >= least) continue;
    least = distance;
    best = static_cast<int>(i);
  }
  return best;
}

bool Passages::joins(const Vec2& a, const Vec2& b) const {
  const int part = part_of(a);
  return part >= 0 && part == part_of(b);
}

Region clip(const Region& area, const Box& box) {
  // A town is one polygon with hundreds of holes: what is far is left out before the overlay.
  const Box around = grown(box, kAround);
  Region near;
  for (const Polygon& polygon : area) {
    Polygon part{cut(polygon.outer, around), {}};
    if (part.outer.empty()) continue;
    for (const Ring& hole : polygon.holes) {
      if (Ring in_part = cut(hole, around); !in_part.empty()) {
        part.holes.push_back(std::move(in_part));
      }
    }
    near.push_back(std::move(part));
  }
  const Vec2 low = box.min(), high = box.max();
  return intersect(near, {{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}}});
}

}  // namespace pedzone
