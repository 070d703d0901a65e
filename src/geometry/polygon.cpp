#include "geometry/polygon.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/overlay.hpp"

namespace pedzone {
namespace {

using overlay::Overlay;
using overlay::Winding;
using Operand = Overlay::Operand;

// numerical: what is smaller or thinner than this is left over from edges that nearly coincide;
// nobody stands on it, and every later step would drag it along.
constexpr double kSliverArea = 0.01;        // [m²]
constexpr double kSliverThickness = 0.002;  // [m]

double perimeter(const Ring& ring) {
  double length = 0.0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    length += (ring[i] - ring[j]).norm();
  }
  return length;
}

bool is_sliver(const Ring& ring) {
  const double size = std::abs(signed_area(ring));
  return size < kSliverArea || size < 0.5 * perimeter(ring) * kSliverThickness;
}

Region without_slivers(Region region) {
  std::erase_if(region, [](const Polygon& polygon) { return is_sliver(polygon.outer); });
  for (Polygon& polygon : region) std::erase_if(polygon.holes, is_sliver);
  return region;
}

Region operate(const Region& a, const Region& b, overlay::Inside inside) {
  Overlay both;
  both.add(a, Operand::kA);
  both.add(b, Operand::kB);
  return without_slivers(both.result(inside));
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

Region repair(const Ring& ring) {
  Overlay one;
  one.add(ring, Operand::kA);
  return without_slivers(one.result([](const Winding& w) { return w.a % 2 != 0; }));
}

Region unite(std::span<const Region> regions) {
  Overlay all;
  for (const Region& region : regions) all.add(region, Operand::kA);
  return without_slivers(all.result([](const Winding& w) { return w.a != 0; }));
}

Region unite(const Region& a, const Region& b) {
  return operate(a, b, [](const Winding& w) { return w.a != 0 || w.b != 0; });
}

Region subtract(const Region& a, const Region& b) {
  return operate(a, b, [](const Winding& w) { return w.a != 0 && w.b == 0; });
}

Region intersect(const Region& a, const Region& b) {
  return operate(a, b, [](const Winding& w) { return w.a != 0 && w.b != 0; });
}

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
