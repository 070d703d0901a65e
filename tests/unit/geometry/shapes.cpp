#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace pedzone::shapes {
namespace {

struct Cell {
  std::int64_t x, y;
  auto operator<=>(const Cell&) const = default;
};

Cell cell_of(const Vec2& point) {
  return {std::llround(point.x() * 1e3), std::llround(point.y() * 1e3)};
}

int turn(const Cell& a, const Cell& b, const Cell& c) {
  const std::int64_t z = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return (z > 0) - (z < 0);
}

bool strictly_between(const Cell& a, const Cell& b, const Cell& c) {
  return turn(a, b, c) == 0 && c != a && c != b && std::min(a.x, b.x) <= c.x &&
         c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y && c.y <= std::max(a.y, b.y);
}

struct Piece {
  Cell a, b;
};

void add_pieces(const Ring& ring, std::vector<Piece>& out) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    out.push_back({cell_of(ring[i]), cell_of(ring[(i + 1) % ring.size()])});
  }
}

std::string ring_defect(const Ring& ring, double sign) {
  if (ring.size() < 3) return "ring with fewer than three points";
  std::set<Cell> seen;
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!ring[i].allFinite()) return "coordinate that is no number";
    if (!seen.insert(cell_of(ring[i])).second) return "ring comes to a point twice";
    twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  }
  return twice * sign > 0.0 ? "" : "ring runs the wrong way round";
}

}  // namespace

double uniform(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

Ring box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Region box_region(double left, double bottom, double right, double top) {
  return {{box(left, bottom, right, top), {}}};
}

Ring star(Random& random, const Vec2& centre, double size, int corners) {
  std::vector<double> angles;
  for (int i = 0; i < corners; ++i) {
    angles.push_back(2.0 * kPi * (i + uniform(random, 0.0, 0.9)) / corners);
  }
  Ring ring;
  for (const double angle : angles) {
    ring.push_back(centre + unit(angle) * size * uniform(random, 0.2, 1.0));
  }
  return ring;
}

Ring scribble(Random& random, const Vec2& centre, double size, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    ring.push_back(centre + Vec2(uniform(random, -size, size), uniform(random, -size, size)));
  }
  return ring;
}

Region obstacle_scene(Random& random, double size, int count) {
  std::vector<Region> obstacles;
  for (int i = 0; i < count; ++i) {
    const Vec2 centre(uniform(random, 0.0, size), uniform(random, 0.0, size));
    if (i % 2 == 0) {
      obstacles.push_back(repair(star(random, centre, uniform(random, 1.0, 5.0), 5 + i % 6)));
    } else {
      const double width = uniform(random, 0.5, 6.0), height = uniform(random, 0.5, 6.0);
      obstacles.push_back(
          box_region(centre.x(), centre.y(), centre.x() + width, centre.y() + height));
    }
  }
  return subtract(box_region(0.0, 0.0, size, size), unite(obstacles));
}

int winding_number(const Ring& ring, const Vec2& point) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 p = ring[i] - point, q = ring[(i + 1) % ring.size()] - point;
    sum += std::atan2(cross(p, q), p.dot(q));
  }
  return static_cast<int>(std::lround(sum / (2.0 * kPi)));
}

bool inside_by_winding(const Region& region, const Vec2& point) {
  for (const Polygon& polygon : region) {
    int number = winding_number(polygon.outer, point);
    for (const Ring& hole : polygon.holes) number += winding_number(hole, point);
    if (number != 0) return true;
  }
  return false;
}

double segment_distance(const Vec2& a, const Vec2& b, const Vec2& point) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (a + t * along - point).norm();
}

double border_distance(const Region& region, const Vec2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      nearest = std::min(nearest, segment_distance(ring[i], ring[(i + 1) % ring.size()], point));
    }
  };
  for (const Polygon& polygon : region) {
    look_at(polygon.outer);
    for (const Ring& hole : polygon.holes) look_at(hole);
  }
  return nearest;
}

bool segments_meet(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b) {
  const auto side = [](const Vec2& s, const Vec2& t, const Vec2& u) {
    const double z = cross(t - s, u - s);
    return (z > 0.0) - (z < 0.0);
  };
  const auto on = [](const Vec2& s, const Vec2& t, const Vec2& u) {
    return (u - s).dot(u - t) <= 0.0;
  };
  const int a_side = side(p, q, a), b_side = side(p, q, b);
  const int p_side = side(a, b, p), q_side = side(a, b, q);
  if (a_side * b_side < 0 && p_side * q_side < 0) return true;
  return (a_side == 0 && on(p, q, a)) || (b_side == 0 && on(p, q, b)) ||
         (p_side == 0 && on(a, b, p)) || (q_side == 0 && on(a, b, q));
}

std::string defect(const Region& region) {
  std::vector<Piece> pieces;
  for (const Polygon& polygon : region) {
    std::string found = ring_defect(polygon.outer, 1.0);
    if (!found.empty()) return "outer " + found;
    add_pieces(polygon.outer, pieces);
    for (const Ring& hole : polygon.holes) {
      found = ring_defect(hole, -1.0);
      if (!found.empty()) return "hole: " + found;
      add_pieces(hole, pieces);
      // Corners may lie on the outer ring, the middle of an edge does not.
      const Vec2 middle = 0.5 * (hole[0] + hole[1]);
      if (winding_number(polygon.outer, middle) != 1) return "hole outside its polygon";
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& p = pieces[i];
    for (std::size_t j = i + 1; j < pieces.size(); ++j) {
      const Piece& q = pieces[j];
      if (std::max(p.a.x, p.b.x) < std::min(q.a.x, q.b.x) ||
          std::max(q.a.x, q.b.x) < std::min(p.a.x, p.b.x)) {
        continue;
      }
      if (turn(p.a, p.b, q.a) * turn(p.a, p.b, q.b) < 0 &&
          turn(q.a, q.b, p.a) * turn(q.a, q.b, p.b) < 0) {
        return "borders cross";
      }
      const bool overlap = turn(p.a, p.b, q.a) == 0 && turn(p.a, p.b, q.b) == 0 &&
                           (strictly_between(p.a, p.b, q.a) || strictly_between(p.a, p.b, q.b) ||
                            strictly_between(q.a, q.b, p.a) || (p.a == q.b && p.b == q.a) ||
                            (p.a == q.a && p.b == q.b));
      if (overlap) return "borders run along each other";
    }
  }
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Vec2 middle = 0.5 * (region[i].outer[0] + region[i].outer[1]);
    for (std::size_t j = 0; j < region.size(); ++j) {
      if (i != j && inside_by_winding({region[j]}, middle)) return "polygons overlap";
    }
  }
  return "";
}

}  // namespace pedzone::shapes
