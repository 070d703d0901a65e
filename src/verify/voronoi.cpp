#include "verify/voronoi.hpp"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <map>

#include "verify/ground.hpp"
#include "zone/shapes.hpp"

namespace pedzone::verify {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using GridPoint = boost::polygon::point_data<std::int32_t>;

constexpr double kGrid = 1e-4;   // [m] numerical: Boost.Polygon works on whole numbers
constexpr int kRoundSides = 16;  // numerical: area of such a polygon is 1.3 % above the circle's

/// Whom each person borders on, by Boost.Polygon. People at the same place of the grid share the
/// neighbours of the first of them.
std::vector<std::vector<std::size_t>> neighbours_of(std::span<const Vec2> points) {
  std::vector<GridPoint> grid;
  std::vector<std::size_t> first;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> known;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::pair place{static_cast<std::int32_t>(std::lround(points[i].x() / kGrid)),
                          static_cast<std::int32_t>(std::lround(points[i].y() / kGrid))};
    if (!known.emplace(place, i).second) continue;
    grid.emplace_back(place.first, place.second);
    first.push_back(i);
  }
  Diagram diagram;
  boost::polygon::construct_voronoi(grid.begin(), grid.end(), &diagram);
  std::vector<std::vector<std::size_t>> neighbours(points.size());
  for (const Diagram::cell_type& cell : diagram.cells()) {
    const Diagram::edge_type* edge = cell.incident_edge();
    if (edge == nullptr) continue;  // one point only
    const std::size_t owner = first[cell.source_index()];
    do {
      neighbours[owner].push_back(first[edge->twin()->cell()->source_index()]);
      edge = edge->next();
    } while (edge != cell.incident_edge());
  }
  return neighbours;
}

bool is_convex(const Ring& ring) {
  constexpr double kStraight = -1e-9;  // [m²] numerical
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()], &c = ring[(i + 2) % ring.size()];
    if (cross(b - a, c - b) < kStraight) return false;
  }
  return true;
}

/// All that is nearer to `own` than to `other`.
Ring nearer_part(const Ring& ring, const Vec2& own, const Vec2& other) {
  const Vec2 middle = 0.5 * (own + other);
  return left_part(ring, middle, middle + left_of(other - own));
}

Ring rounded(Ring ring, const Vec2& centre, double most) {
  for (int side = 0; side < kRoundSides; ++side) {
    const Vec2 out = unit(2.0 * kPi * side / kRoundSides);
    const Vec2 edge = centre + most * out;
    ring = left_part(ring, edge, edge + left_of(out));
  }
  return ring;
}

/// The part of `ring` in the walkable area that `person` stands in.
Region own_part(const Ring& ring, const Region& walkable, const Vec2& person) {
  const Region parts = intersect(repair(ring), walkable);
  for (const Polygon& part : parts) {
    if (contains({part}, person)) return {part};
  }
  return {};
}

}  // namespace

Ring left_part(const Ring& ring, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  Ring part;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
    const double left_from = cross(along, from - a), left_to = cross(along, to - a);
    if (left_from >= 0.0) part.push_back(from);
    if ((left_from > 0.0 && left_to < 0.0) || (left_from < 0.0 && left_to > 0.0)) {
      part.push_back(from + left_from / (left_from - left_to) * (to - from));
    }
  }
  return part;
}

VoronoiCells::VoronoiCells(const Region& walkable, std::span<const Vec2> points,
                           std::optional<double> most)
    : cells_(points.size()), areas_(points.size()) {
  if (walkable.empty()) return;
  const Box extent = box_of(walkable);
  const bool plain =
      walkable.size() == 1 && walkable.front().holes.empty() && is_convex(walkable.front().outer);
  const Ring whole =
      plain ? walkable.front().outer
            : box(extent.min().x(), extent.min().y(), extent.max().x(), extent.max().y());
  const auto neighbours = neighbours_of(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!contains(walkable, points[i])) continue;
    Ring ring = whole;
    for (const std::size_t other : neighbours[i]) {
      ring = nearer_part(ring, points[i], points[other]);
    }
    if (most) ring = rounded(std::move(ring), points[i], *most);
    if (ring.size() < 3) continue;
    cells_[i] = plain ? Region{{ring, {}}} : own_part(ring, walkable, points[i]);
    areas_[i] = pedzone::area(cells_[i]);
  }
}

double VoronoiCells::area_within(std::size_t person, const Ring& convex) const {
  const auto cut = [&](Ring ring) {
    for (std::size_t k = 0; k < convex.size(); ++k) {
      ring = left_part(ring, convex[k], convex[(k + 1) % convex.size()]);
    }
    return signed_area(ring);
  };
  double sum = 0.0;
  for (const Polygon& polygon : cells_[person]) {
    sum += cut(polygon.outer);
    for (const Ring& hole : polygon.holes) sum += cut(hole);
  }
  return sum;
}

double VoronoiCells::density(const Ring& convex) const {
  double persons = 0.0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (areas_[i] > 0.0) persons += area_within(i, convex) / areas_[i];
  }
  return persons / signed_area(convex);
}

std::optional<double> VoronoiCells::mean(std::span<const double> values, const Ring& convex) const {
  double sum = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (areas_[i] <= 0.0) continue;
    const double part = area_within(i, convex);
    sum += part * values[i];
    weight += part;
  }
  if (weight <= 0.0) return {};
  return sum / weight;
}

}  // namespace pedzone::verify
