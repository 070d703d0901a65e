#include "crowd/state/route.hpp"

#include <algorithm>

#include "geometry/segment.hpp"

namespace pedzone {
namespace {

constexpr double kNarrowest = 0.2;  // [m] half width of the narrowest passage of WayFinder
constexpr double kGrazing = 0.8;    // numerical: share of the radius that must pass a corner

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

/// The shortest way to the aim. It ends where the aim is nearest to the way's last corner, if that
/// is in view from there.
std::vector<Vec2> shortest_way(const Zone& zone, const Vec2& from, double clearance,
                               const Route& route) {
  const Vec2 &a = route.aim_a, &b = route.aim_b;
  auto way = zone.ways.way_to_line(from, a, b);
  if (!way) return {};
  const Vec2 corner = way->size() > 1 ? (*way)[way->size() - 2] : from;
  const Vec2 nearest = nearest_on(a, b, corner);
  const bool in_view = zone.walls.free_line(corner, nearest, clearance);
  way->back() = in_view ? nearest : nearest_on(a, b, way->back());
  return *std::move(way);
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
  if (!route.last_in_view) route.points = shortest_way(zone, from, clearance, route);
  route.found = route.last_in_view || !route.points.empty();
  if (route.points.empty()) route.points.push_back(straight);
  go_on_to(route, 0);
}

}  // namespace pedzone
