#include "zone/passage.hpp"

#include <limits>

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
  Region near;
  for (const Polygon& polygon : area) {
    if (box.intersects(box_of(polygon.outer))) near.push_back(polygon);
  }
  const Vec2 low = box.min(), high = box.max();
  return intersect(near, {{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}}});
}

}  // namespace pedzone
