// How a disc moves among walls: it goes on to the first wall it would touch, then along it.
//
// With all the room it has, the disc's centre stays a radius away from walls. Where two walls stop
// it that leave a gap between them, narrower than the disc but free beyond, its centre is let
// through; it regains its distance where it can, a little with every call.
#include <cmath>

#include "geometry/segment.hpp"
#include "geometry/wall_index.hpp"

namespace pedzone {
namespace {

// numerical: what counts as touching, and as moving towards a wall (share of the move).
constexpr double kTouch = 1e-9;  // [m]
// numerical: the least room kept in front of a wall; below it, rounding could pass for a crossing.
constexpr double kLeastRoom = 1e-3;  // [m]
// numerical: a disc may be short of its radius by this without being pushed.
constexpr double kPushSlack = 1e-6;  // [m]
// assumed: room regained a call; with steps of 0.1 s nobody is moved faster than 0.2 m/s by it.
constexpr double kPushStep = 0.02;  // [m]
// assumed: a gap that a body is squeezed through has half this much room at least; half of what
// WayFinder takes for passable, as people do not walk in its very middle.
constexpr double kSqueezeRoom = 0.1;  // [m]
// numerical: a push has to give this much room for its length; less, and it would drift along walls
// that are nearly parallel.
constexpr double kWorthwhileGain = 0.05;
// numerical: cosine (and length of a sum of unit vectors) below which a direction does not count.
constexpr double kParallel = 0.1;
// numerical: walls in turn that one move may touch; a step is shorter than any three corners.
constexpr int kMostTouches = 6;

bool is_finite(const Vec2& v) { return std::isfinite(v.x()) && std::isfinite(v.y()); }

/// Share of the move at which a point comes within `radius` of a corner it is not yet within.
std::optional<double> corner_share(const Vec2& offset, const Vec2& move, double radius) {
  const double towards = offset.dot(move);
  if (towards >= -kTouch * move.norm() * offset.norm()) return std::nullopt;
  const double gap = offset.squaredNorm() - radius * radius;
  if (gap <= 0.0) return 0.0;
  const double length2 = move.squaredNorm();
  const double root2 = towards * towards - length2 * gap;
  if (root2 < 0.0) return std::nullopt;
  return (-towards - std::sqrt(root2)) / length2;
}

}  // namespace

std::optional<WallIndex::Hit> WallIndex::first_hit(const Vec2& from, const Vec2& move,
                                                   double radius) const {
  const double reach = move.norm();
  Hit best{2.0, Vec2::Zero()};
  std::uint32_t best_wall = 0;
  const auto offer = [&](std::uint32_t index, double share, const Vec2& normal) {
    if (share > 1.0 || share > best.share || (share == best.share && index >= best_wall)) return;
    best = {std::max(0.0, share), normal};
    best_wall = index;
  };
  grid_.visit_along(from, from + move, radius, [&](std::uint32_t index) {
    const Wall& wall = walls_[index];
    const Vec2 along = (wall.b - wall.a).normalized();
    const double length = (wall.b - wall.a).norm();
    const double height = cross(along, from - wall.a);
    const double distance = (nearest_on(wall.a, wall.b, from) - from).norm();
    const double kept = std::min(radius, distance);
    const bool front = height > kTouch || (bounded_ && height > -kTouch) || height >= 0.0;
    const Vec2 normal = front ? left_of(along) : -left_of(along);
    const double approach = move.dot(normal);
    if (approach < -kTouch * reach && std::abs(height) >= kept - kTouch) {
      const double share = std::max(0.0, (std::abs(height) - kept) / -approach);
      const double foot = along.dot(from + share * move - wall.a);
      if (foot >= 0.0 && foot <= length) offer(index, share, normal);
    }
    if (distance <= kTouch) return true;  // the line's normal says it all
    for (const Vec2* corner : {&wall.a, &wall.b}) {
      const std::optional<double> share = corner_share(from - *corner, move, kept);
      if (share) offer(index, *share, (from + *share * move - *corner).normalized());
    }
    return true;
  });
  if (best.share > 1.0) return std::nullopt;
  return best;
}

WallIndex::Walk WallIndex::walk_along(const Vec2& from, const Vec2& move, double radius) const {
  Walk walk;
  walk.end = from;
  Vec2 rest = move;
  Vec2 last = Vec2::Zero();
  for (int touches = 0; touches < kMostTouches && rest.norm() > kTouch; ++touches) {
    const std::optional<Hit> hit = first_hit(walk.end, rest, radius);
    if (!hit) {
      walk.end += rest;
      break;
    }
    walk.end += hit->share * rest;
    rest *= 1.0 - hit->share;
    rest -= std::min(0.0, rest.dot(hit->normal)) * hit->normal;
    // Along the second wall it would go back into the first, or back where it came from.
    if (touches > 0 && (rest.dot(last) < -kTouch * rest.norm() || rest.dot(move) <= 0.0)) {
      walk.jammed = true;
      walk.first = last;
      walk.second = hit->normal;
      break;
    }
    last = hit->normal;
  }
  return walk;
}

/// A direction that leads on from a jam through a gap between its two walls: the wished one, the
/// one between them, or one along either of them.
std::optional<Vec2> WallIndex::way_through(const Vec2& from, const Vec2& move, double radius,
                                           double room_kept, const Walk& jam) const {
  for (const Vec2& direction :
       {move, Vec2(-jam.first - jam.second), left_of(jam.first), Vec2(-left_of(jam.first)),
        left_of(jam.second), Vec2(-left_of(jam.second))}) {
    if (direction.dot(move) < kParallel * direction.norm() * move.norm()) continue;
    const Vec2 ahead = direction.normalized();
    if (free_line(from, from + (radius + move.dot(ahead)) * ahead, room_kept)) return ahead;
  }
  return std::nullopt;
}

/// Goes on from a jam through the gap between its two walls, if there is one that leads on.
Vec2 WallIndex::squeeze(const Vec2& from, const Vec2& move, double radius, const Walk& jam) const {
  if (move.norm() <= kTouch) return from;
  const double room_kept = std::min(kSqueezeRoom, room(from, radius));
  const std::optional<Vec2> ahead = way_through(from, move, radius, room_kept, jam);
  if (!ahead) return from;
  const Vec2 end = walk_along(from, move.dot(*ahead) * *ahead, room_kept).end;
  // Towards the middle of the gap, never back out of it.
  const std::optional<Nearest> place = nearest(end, radius);
  if (!place) return end;
  const Vec2 away = away_from(*place, end);
  const Vec2 sideways = away - away.dot(*ahead) * *ahead;
  return gain_room(end, sideways * std::min(kPushStep, radius - place->distance), place->distance);
}

/// Follows `push` if that gives more room to all walls than there is (`before`), else half of it,
/// and so on.
Vec2 WallIndex::gain_room(const Vec2& point, const Vec2& push, double before) const {
  const double limit = before + 2.0 * push.norm();
  Vec2 part = push;
  for (int halvings = 0; halvings < 6 && part.norm() > kPushSlack; ++halvings, part *= 0.5) {
    if (first_hit(point, part, kLeastRoom)) continue;
    const Vec2 moved = point + part;
    // A gain that is a small part of the way is not worth it: the walls are nearly parallel.
    if (room(moved, limit) >= before + kWorthwhileGain * part.norm() && inside(moved)) return moved;
  }
  return point;
}

/// Up to `step` away from the nearest wall, or from the nearest two where they form a corner.
Vec2 WallIndex::push_out(const Vec2& point, double radius, double step) const {
  const std::optional<Nearest> place = nearest(point, radius - kPushSlack);
  if (!place) return point;
  const Vec2 away = away_from(*place, point);
  const double wanted = std::min(step, radius - place->distance);
  // Of the walls that would be as near after the push, the one that is most opposed to it.
  Vec2 opposed = away;
  const double reach = std::min(radius, place->distance + 2.0 * wanted);
  visit_near(point, reach, [&](std::uint32_t index) {
    const Wall& wall = walls_[index];
    const Vec2 offset = point - nearest_on(wall.a, wall.b, point);
    const double distance = offset.norm();
    if (distance >= reach) return;
    const Vec2 normal =
        distance > kTouch ? Vec2(offset / distance) : left_of((wall.b - wall.a).normalized());
    if (normal.dot(away) < opposed.dot(away)) opposed = normal;
  });
  const Vec2 both = away + opposed;
  if (both.norm() > kParallel) {
    const Vec2 moved = gain_room(point, wanted * both.normalized(), place->distance);
    if (moved != point) return moved;
  }
  return gain_room(point, wanted * away, place->distance);
}

Vec2 WallIndex::slide(const Vec2& from, const Vec2& to, double radius) const {
  if (!is_finite(from) || !is_finite(to)) return from;
  if (!inside(from)) return nearest_inside(from, radius);
  const double size = std::max(radius, kLeastRoom);
  const Vec2 move = to - from;
  const double reach = move.norm() + size;
  const double room_here = room(from, reach);
  if (room_here >= reach) return to;
  // Most who walk near a wall come no nearer to it than they may: nothing stops or turns them.
  if (move.norm() > kTouch && free_line(from, to, size + kPushSlack)) return from + move;

  const Walk walk = walk_along(from, move, std::clamp(room_here, kLeastRoom, size));
  Vec2 end = walk.end;
  if (walk.jammed) {
    const double left = std::max(0.0, move.norm() - (walk.end - from).norm());
    end = squeeze(walk.end, left * (to - walk.end).normalized(), size, walk);
  }
  if (end == walk.end) end = push_out(end, size, kPushStep);
  return inside(end) ? end : from;
}

}  // namespace pedzone
