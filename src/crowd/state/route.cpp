#include "crowd/state/route.hpp"

#include <algorithm>
#include <array>

#include "geometry/segment.hpp"

namespace pedzone {
namespace {

constexpr double kNarrowest = 0.2;  // [m] half width of the narrowest passage of WayFinder
constexpr double kGrazing = 0.8;    // numerical: share of the radius that must pass a corner
constexpr double kSamePoint = 0.5;  // [m] numerical: aims nearer than this are one candidate

double length_from(const Vec2& from, const std::vector<Vec2>& points) {
  double length = 0.0;
  Vec2 at = from;
  for (const Vec2& point : points) {
    length += (point - at).norm();
    at = point;
  }
  return length;
}

/// Shortens the destination by the radius at both ends and moves what is left to where the body
/// has room (a portal lies on the border of the walkable area).
void set_aim(const WallIndex& walls, double radius, Route& route) {
  const Vec2 along = route.destination.b - route.destination.a;
  const double length = along.norm();
  const double cut = std::min(radius, 0.5 * length);
  const Vec2 inset = length > 0.0 ? Vec2(along * (cut / length)) : Vec2::Zero();
  route.aim_a = walls.nearest_inside(route.destination.a + inset, radius);
  route.aim_b = walls.nearest_inside(route.destination.b - inset, radius);
}

/// The shortest way to any of a few points of the aim. From the last corner of each way, the
/// nearest point of the aim that is in view replaces the one that was asked for.
std::optional<std::vector<Vec2>> shortest_way(const Zone& zone, const Vec2& from, double clearance,
                                              const Route& route) {
  const Vec2 &a = route.aim_a, &b = route.aim_b;
  const std::array<Vec2, 4> aims{nearest_on(a, b, from), 0.5 * (a + b), a, b};
  std::optional<std::vector<Vec2>> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < aims.size(); ++k) {
    const bool known = std::any_of(aims.begin(), aims.begin() + k, [&](const Vec2& other) {
      return (other - aims[k]).norm() < kSamePoint;
    });
    if (known) continue;
    auto way = zone.ways.way(from, aims[k]);
    if (!way || way->empty()) continue;
    way->back() = aims[k];
    if (way->size() > 1) {
      const Vec2& corner = (*way)[way->size() - 2];
      const Vec2 nearest = nearest_on(a, b, corner);
      if (zone.walls.free_line(corner, nearest, clearance)) way->back() = nearest;
    }
    const double length = length_from(from, *way);
    if (length < least) {
      least = length;
      best = std::move(way);
    }
  }
  return best;
}

}  // namespace

double passing_clearance(double radius) { return std::min(kGrazing * radius, kNarrowest); }

void go_on_to(Route& route, std::size_t index) {
  route.next = index;
  route.beside = Vec2::Zero();
  route.rest = route.beyond;
  for (std::size_t k = index; k + 1 < route.points.size(); ++k) {
    route.rest += (route.points[k + 1] - route.points[k]).norm();
  }
}

Vec2 heading_point(const Route& route, const Vec2& position) {
  if (route.on_last() && route.last_in_view) {
    return nearest_on(route.aim_a, route.aim_b, position);
  }
  return route.points[route.next] + route.beside;
}

double way_left(const Route& route, const Vec2& position) {
  return (heading_point(route, position) - position).norm() + route.rest;
}

void plan(const Zone& zone, const Vec2& from, double radius, const Destination& destination,
          Route& route) {
  const double clearance = passing_clearance(radius);
  route.destination = destination;
  route.beyond = 0.0;
  route.start = from;
  set_aim(zone.walls, radius, route);
  const Vec2 straight = nearest_on(route.aim_a, route.aim_b, from);
  route.points.clear();
  route.last_in_view = zone.walls.free_line(from, straight, clearance);
  if (!route.last_in_view) {
    if (auto way = shortest_way(zone, from, clearance, route)) {
      route.points.assign(way->begin(), way->end());
    }
  }
  route.found = route.last_in_view || !route.points.empty();
  if (route.points.empty()) route.points.push_back(straight);
  go_on_to(route, 0);
}

}  // namespace pedzone
