#include "geometry/overlay.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone::overlay {
namespace {

std::vector<GridPoint> grid_ring(const Ring& ring) {
  std::vector<GridPoint> points;
  points.reserve(ring.size());
  for (const Vec2& point : ring) {
    if (!std::isfinite(point.x()) || !std::isfinite(point.y())) continue;
    const GridPoint p = to_grid(point);
    if (points.empty() || points.back() != p) points.push_back(p);
  }
  while (points.size() > 1 && points.front() == points.back()) points.pop_back();
  if (points.size() < 3) points.clear();
  return points;
}

double signed_area(const std::vector<GridPoint>& ring) {
  double twice = 0.0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const double px = static_cast<double>(ring[j].x - ring[0].x);
    const double py = static_cast<double>(ring[j].y - ring[0].y);
    const double qx = static_cast<double>(ring[i].x - ring[0].x);
    const double qy = static_cast<double>(ring[i].y - ring[0].y);
    twice += px * qy - qx * py;
  }
  return 0.5 * twice;
}

void add_edges(const std::vector<GridPoint>& ring, Winding step, std::vector<BorderPiece>& edges) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if (ring[j] < ring[i]) {
      edges.push_back({ring[j], ring[i], step, {}});
    } else {
      edges.push_back({ring[i], ring[j], {-step.a, -step.b}, {}});
    }
  }
}

Winding step_of(Overlay::Operand operand, int turns) {
  return operand == Overlay::Operand::kA ? Winding{turns, 0} : Winding{0, turns};
}

/// Whether a polygon keeps what polygon.hpp promises, so that its winding numbers are 0 and 1.
bool is_valid(std::vector<BorderPiece> edges) {
  merge(edges);
  if (!is_arranged(edges)) return false;
  label(edges);
  return std::ranges::all_of(edges, [](const BorderPiece& edge) {
    const int below = edge.below.a + edge.below.b;
    const int above = below + edge.step.a + edge.step.b;
    return std::min(below, above) == 0 && std::max(below, above) == 1;
  });
}

Region even_odd(const Ring& ring) {
  Overlay one;
  one.add(ring, Overlay::Operand::kA);
  return one.result([](const Winding& w) { return w.a % 2 != 0; });
}

}  // namespace

void Overlay::add(const Ring& ring, Operand operand) {
  const std::vector<GridPoint> points = grid_ring(ring);
  if (!points.empty()) add_edges(points, step_of(operand, 1), edges_);
}

void Overlay::add_turned(const Ring& ring, Operand operand, bool hole) {
  const std::vector<GridPoint> points = grid_ring(ring);
  if (points.empty()) return;
  const bool turn = (signed_area(points) < 0.0) != hole;
  add_edges(points, step_of(operand, turn ? -1 : 1), edges_);
}

void Overlay::add(const Polygon& polygon, Operand operand) {
  add_turned(polygon.outer, operand, false);
  for (const Ring& hole : polygon.holes) add_turned(hole, operand, true);
}

void Overlay::add(const Region& region, Operand operand) {
  for (const Polygon& polygon : region) {
    Overlay alone;
    alone.add(polygon, operand);
    if (is_valid(alone.edges_)) {
      edges_.insert(edges_.end(), alone.edges_.begin(), alone.edges_.end());
      continue;
    }
    // Winding numbers of crossed rings could cancel out those of other polygons.
    Overlay repaired;
    repaired.add(even_odd(polygon.outer), Operand::kA);
    for (const Ring& hole : polygon.holes) repaired.add(even_odd(hole), Operand::kB);
    for (const Polygon& part :
         repaired.result([](const Winding& w) { return w.a != 0 && w.b == 0; })) {
      add(part, operand);
    }
  }
}

Region Overlay::result(Inside inside) {
  arrange(edges_);
  label(edges_);
  return trace(edges_, inside);
}

}  // namespace pedzone::overlay
