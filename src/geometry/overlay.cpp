// Boost.Polygon works on 32-bit integers, here millimetres from the lower left corner of all that
// is combined. Its rings may come to a point twice: they are taken apart at such points.
#include "geometry/overlay.hpp"

#include <algorithm>
#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <limits>
#include <map>

namespace pedzone::overlay {
namespace {

namespace bp = boost::polygon;
using Point = bp::point_data<int>;
using Points = std::vector<Point>;
using Segment = bp::segment_data<int>;
using Set = bp::polygon_set_data<int>;
using Boolean = bp::arbitrary_boolean_op<int>;

constexpr double kGridPerMetre = 1000.0;
// numerical: coordinates beyond these do not fit into 64 and 32 bits and are clamped [mm].
constexpr double kLargest = 1e11;
constexpr std::int64_t kWidest = 1'000'000'000;
// numerical: what is smaller or thinner than this is left over from edges that nearly coincide;
// nobody stands on it, and every later step would drag it along.
constexpr double kSliverArea = 0.01;        // [m²]
constexpr double kSliverThickness = 0.002;  // [m]

GridPoint to_grid(const Vec2& point) {
  const auto coordinate = [](double metres) {
    return std::llround(std::clamp(metres * kGridPerMetre, -kLargest, kLargest));
  };
  return {coordinate(point.x()), coordinate(point.y())};
}

Vec2 from_grid(const GridPoint& point) {
  return {static_cast<double>(point.x) / kGridPerMetre,
          static_cast<double>(point.y) / kGridPerMetre};
}

template <class P>
void drop_repeated(std::vector<P>& ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

/// Empty where fewer than three points remain.
GridRing grid_ring(const Ring& ring) {
  GridRing points;
  points.reserve(ring.size());
  for (const Vec2& point : ring) {
    if (finite(point)) points.push_back(to_grid(point));
  }
  drop_repeated(points);
  if (points.size() < 3) points.clear();
  return points;
}

/// Positive: c is to the left of a → b; zero: on the line through them. Exact.
std::int64_t turn(const Point& a, const Point& b, const Point& c) {
  const auto difference = [](int to, int from) { return std::int64_t{to} - from; };
  return difference(b.x(), a.x()) * difference(c.y(), a.y()) -
         difference(b.y(), a.y()) * difference(c.x(), a.x());
}

bool counter_clockwise(const Points& ring) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    twice += static_cast<double>(turn(ring[0], ring[i], ring[i + 1]));
  }
  return twice > 0.0;
}

/// Cuts a ring wherever it comes to a point again: rings that do so nowhere.
std::vector<Points> loops_at_repeated_points(const Points& ring) {
  std::vector<Points> loops;
  Points walk;
  std::map<Point, std::size_t> place;  // of each point in the walk
  const auto close = [&](std::size_t from) {
    const auto begin = walk.begin() + static_cast<std::ptrdiff_t>(from);
    for (auto it = begin; it != walk.end(); ++it) place.erase(*it);
    if (walk.end() - begin > 2) loops.emplace_back(begin, walk.end());
    walk.erase(begin, walk.end());
  };
  for (const Point& point : ring) {
    if (const auto found = place.find(point); found != place.end()) close(found->second);
    place[point] = walk.size();
    walk.push_back(point);
  }
  close(0);
  return loops;
}

/// The pieces of a ring's edges between the places where these meet, with the edge's number.
std::vector<std::pair<std::size_t, Segment>> pieces_of(const Points& ring) {
  std::vector<Segment> edges;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    edges.emplace_back(ring[j], ring[i]);
  }
  std::vector<std::pair<std::size_t, Segment>> pieces;
  bp::intersect_segments(pieces, edges.begin(), edges.end());
  return pieces;
}

/// A ring that crosses itself as rings that do not.
std::vector<Points> loops_of(const Points& ring) {
  std::vector<Points> on_edge(ring.size());
  for (const auto& [edge, piece] : pieces_of(ring)) {
    on_edge[edge].push_back(piece.low());
    on_edge[edge].push_back(piece.high());
  }
  Points path;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    // Rounding may move a cut by a millimetre; the order along the edge stays.
    const double dx = ring[i].x() - static_cast<double>(ring[j].x()),
                 dy = ring[i].y() - static_cast<double>(ring[j].y());
    const auto along = [&](const Point& p) {
      return std::pair(dx * (p.x() - static_cast<double>(ring[j].x())) +
                           dy * (p.y() - static_cast<double>(ring[j].y())),
                       std::pair(p.x(), p.y()));
    };
    std::ranges::sort(on_edge[i], {}, along);
    path.insert(path.end(), on_edge[i].begin(), on_edge[i].end());
  }
  drop_repeated(path);
  return loops_at_repeated_points(path);
}

void insert(Set& set, const Points& ring, bool hole = false) {
  const bp::direction_1d direction = counter_clockwise(ring) ? bp::COUNTERCLOCKWISE : bp::CLOCKWISE;
  set.insert_vertex_sequence(ring.begin(), ring.end(), direction, hole);
}

/// The operators of polygon_set_data would cut and sort each operand once more.
Set boolean(const Set& a, Boolean::BOOLEAN_OP_TYPE operation, const Set& b) {
  Set result;
  Boolean().execute(result, a.begin(), a.end(), b.begin(), b.end(), operation);
  return result;
}

Set even_odd(const Points& ring) {
  Set result;
  for (const Points& loop : loops_of(ring)) {
    Set one;
    insert(one, loop);
    result = boolean(result, Boolean::BOOLEAN_XOR, one);
  }
  return result;
}

/// Whether a ring comes to no point twice.
bool is_simple(const Points& ring) {
  Points sorted = ring;
  std::ranges::sort(sorted, std::less<>());
  return std::ranges::adjacent_find(sorted) == sorted.end() &&
         pieces_of(ring).size() == ring.size();
}

/// The integers that Boost.Polygon is given, and back.
class Grid {
 public:
  Grid(const Cover& a, const Cover& b) {
    constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::max();
    origin_ = {kNone, kNone};
    for (const Cover* cover : {&a, &b}) {
      for (const Cover::Part& part : cover->parts()) {
        for (const GridRing& ring : part.rings) {
          for (const GridPoint& p : ring) {
            origin_ = {std::min(origin_.x, p.x), std::min(origin_.y, p.y)};
          }
        }
      }
    }
  }

  Set set_of(const Cover& cover) const {
    Set set;
    for (const Cover::Part& part : cover.parts()) {
      if (part.any) {
        set.insert(made_valid(part));
        continue;
      }
      // Boost.Polygon counts how often a place is covered: a hole takes away what is round it.
      for (std::size_t i = 0; i < part.rings.size(); ++i) insert(set, local(part.rings[i]), i > 0);
    }
    return set;
  }

  /// Begins at its lowest point of the leftmost; points in straight pieces of border are left out.
  Ring ring_of(const Points& points) const {
    Points corners;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Point &before = points[(i + count - 1) % count], &after = points[(i + 1) % count];
      if (turn(before, points[i], after) != 0) corners.push_back(points[i]);
    }
    if (corners.size() < 3) return {};
    std::ranges::rotate(corners, std::ranges::min_element(corners, {}, [](const Point& p) {
                          return std::pair(p.x(), p.y());
                        }));
    Ring ring;
    for (const Point& p : corners) {
      ring.push_back(from_grid({p.x() + origin_.x, p.y() + origin_.y}));
    }
    return ring;
  }

 private:
  Set made_valid(const Cover::Part& part) const {
    Set outer, holes;
    for (std::size_t i = 0; i < part.rings.size(); ++i) {
      const Points points = local(part.rings[i]);
      Set& set = i == 0 ? outer : holes;
      if (is_simple(points)) {
        insert(set, points);
      } else {
        set.insert(even_odd(points));
      }
    }
    return part.rings.size() == 1 ? outer : boolean(outer, Boolean::BOOLEAN_NOT, holes);
  }

  Points local(const GridRing& ring) const {
    Points points;
    for (const GridPoint& p : ring) {
      points.emplace_back(static_cast<int>(std::min(p.x - origin_.x, kWidest)),
                          static_cast<int>(std::min(p.y - origin_.y, kWidest)));
    }
    return points;
  }

  GridPoint origin_;
};

double perimeter(const Ring& ring) {
  double length = 0.0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    length += (ring[i] - ring[j]).norm();
  }
  return length;
}

bool is_sliver(const Ring& ring) {
  const double size = std::abs(signed_area(ring));
  return ring.empty() || size < kSliverArea || size < 0.5 * perimeter(ring) * kSliverThickness;
}

/// The simple polygons of one of Boost's, slivers left out.
Region taken_apart(const bp::polygon_with_holes_data<int>& polygon, const Grid& grid) {
  Region region;
  std::vector<Ring> holes;
  const auto add = [&](Points points, bool outer) {
    drop_repeated(points);
    if (counter_clockwise(points) != outer) std::ranges::reverse(points);
    for (const Points& loop : loops_at_repeated_points(points)) {
      Ring ring = grid.ring_of(loop);
      if (is_sliver(ring)) continue;
      if (counter_clockwise(loop)) {
        region.push_back({std::move(ring), {}});
      } else {
        holes.push_back(std::move(ring));
      }
    }
  };
  add(Points(polygon.begin(), polygon.end()), true);
  for (auto hole = polygon.begin_holes(); hole != polygon.end_holes(); ++hole) {
    add(Points(hole->begin(), hole->end()), false);
  }
  for (Ring& hole : holes) {
    const auto holds = [&](const Polygon& part) {
      return std::ranges::all_of(hole, [&](const Vec2& p) {
        return contains({{part.outer, {}}}, p);
      });
    };
    const auto parent = region.size() == 1 ? region.begin() : std::ranges::find_if(region, holds);
    if (parent != region.end()) parent->holes.push_back(std::move(hole));
  }
  return region;
}

std::pair<double, double> start_of(const Ring& ring) { return {ring[0].x(), ring[0].y()}; }

}  // namespace

Vec2 on_grid(const Vec2& point) { return from_grid(to_grid(point)); }

void Cover::add_simple(const Ring& ring) {
  GridRing points = grid_ring(ring);
  if (!points.empty()) parts_.push_back({{std::move(points)}, false});
}

void Cover::add(const Region& region) { add(region, false); }

void Cover::add_any(const Region& region) { add(region, true); }

void Cover::add(const Region& region, bool any) {
  for (const Polygon& polygon : region) {
    Part part{{grid_ring(polygon.outer)}, any};
    if (part.rings[0].empty()) continue;
    for (const Ring& hole : polygon.holes) {
      GridRing points = grid_ring(hole);
      if (!points.empty()) part.rings.push_back(std::move(points));
    }
    parts_.push_back(std::move(part));
  }
}

Region combine(const Cover& a, Operation operation, const Cover& b) {
  const Grid grid(a, b);
  Set result = grid.set_of(a);
  if (operation == Operation::kUnite) {
    result.insert(grid.set_of(b));
  } else {
    const bool rest = operation == Operation::kSubtract;
    result = boolean(result, rest ? Boolean::BOOLEAN_NOT : Boolean::BOOLEAN_AND, grid.set_of(b));
  }
  std::vector<bp::polygon_with_holes_data<int>> polygons;
  result.get(polygons);
  Region region;
  for (const auto& polygon : polygons) {
    for (Polygon& part : taken_apart(polygon, grid)) region.push_back(std::move(part));
  }
  for (Polygon& polygon : region) std::ranges::sort(polygon.holes, {}, start_of);
  std::ranges::sort(region, {}, [](const Polygon& polygon) { return start_of(polygon.outer); });
  return region;
}

}  // namespace pedzone::overlay
