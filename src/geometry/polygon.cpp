#include "geometry/polygon.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/overlay.hpp"

namespace pedzone {
namespace {

using overlay::Cover;
using overlay::Operation;

Region combine(const Region& a, Operation operation, const Region& b) {
  Cover first, second;
  first.add(a);
  second.add(b);
  return overlay::combine(first, operation, second);
}

enum class Side { kOutside, kBorder, kInside };

/// Side of a ring by crossings of the ray to the right.
Side side_of(const Ring& ring, const Vec2& point) {
  bool odd = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 p = ring[j] - point, q = ring[i] - point;
    const double turn = cross(p, q);
    if (turn == 0.0 && p.dot(q) <= 0.0) return Side::kBorder;
    if ((p.y() > 0.0) == (q.y() > 0.0)) continue;
    if ((turn > 0.0) == (q.y() > p.y())) odd = !odd;
  }
  return odd ? Side::kInside : Side::kOutside;
}

}  // namespace

Region repair(const Ring& ring) { return make_valid({{ring, {}}}); }

Region make_valid(const Region& polygons) {
  Cover all;
  all.add_any(polygons);
  return overlay::combine(all, Operation::kUnite, {});
}

Region unite(std::span<const Region> regions) {
  Cover all;
  for (const Region& region : regions) all.add(region);
  return overlay::combine(all, Operation::kUnite, {});
}

Region unite(const Region& a, const Region& b) { return combine(a, Operation::kUnite, b); }

Region subtract(const Region& a, const Region& b) {
  return b.empty() ? a : combine(a, Operation::kSubtract, b);
}

Region intersect(const Region& a, const Region& b) { return combine(a, Operation::kIntersect, b); }

double area(const Region& region) {
  double sum = 0.0;
  for (const Polygon& polygon : region) {
    if (polygon.outer.empty()) continue;
    sum += std::abs(signed_area(polygon.outer));
    for (const Ring& hole : polygon.holes) {
      if (!hole.empty()) sum -= std::abs(signed_area(hole));
    }
  }
  return sum;
}

double signed_area(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    twice += cross(ring[j] - ring[0], ring[i] - ring[0]);
  }
  return 0.5 * twice;
}

bool contains(const Region& region, const Vec2& point) {
  for (const Polygon& polygon : region) {
    const Side outer = side_of(polygon.outer, point);
    if (outer == Side::kOutside) continue;
    if (outer == Side::kBorder) return true;
    const bool in_hole = std::ranges::any_of(
        polygon.holes, [&](const Ring& hole) { return side_of(hole, point) == Side::kInside; });
    if (!in_hole) return true;
  }
  return false;
}

}  // namespace pedzone
