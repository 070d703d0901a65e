// The nearest place with room.
//
// The places with room are bounded by arcs round wall ends and by lines along walls, all at the
// clearance. The nearest one is the foot of a perpendicular on one of these, or a point where two
// of them meet: all are listed, the nearest that has room is taken.
#include <algorithm>
#include <cmath>

#include "geometry/segment.hpp"
#include "geometry/wall_index.hpp"

namespace pedzone {
namespace {

// numerical: places are this much farther from walls than asked for, so that they still qualify
// after rounding.
constexpr double kExtra = 1e-6;     // [m]
constexpr double kOnBorder = 1e-9;  // [m]
// assumed: how many clearances beyond the nearest wall a place with room is looked for before the
// passage counts as narrow.
constexpr double kSearchReach = 4.0;
// numerical: climbing out of a narrow place: steps as a share of the clearance, and their number
// and least length.
constexpr double kClimbShare = 0.5;
constexpr int kMostClimbs = 64;

struct Line {
  Vec2 point, direction;  // unit direction
};

void meet(const Line& s, const Line& t, std::vector<Vec2>& out) {
  const double turn = cross(s.direction, t.direction);
  if (std::abs(turn) < kOnBorder) return;
  out.push_back(s.point + cross(t.point - s.point, t.direction) / turn * s.direction);
}

void meet(const Line& line, const Vec2& centre, double radius, std::vector<Vec2>& out) {
  const double along = (centre - line.point).dot(line.direction);
  const Vec2 foot = line.point + along * line.direction;
  const double half2 = radius * radius - (foot - centre).squaredNorm();
  if (half2 < 0.0) return;
  for (const double sign : {1.0, -1.0})
    out.push_back(foot + sign * std::sqrt(half2) * line.direction);
}

void meet(const Vec2& centre, const Vec2& other, double radius, std::vector<Vec2>& out) {
  const Vec2 between = other - centre;
  const double half2 = radius * radius - 0.25 * between.squaredNorm();
  if (half2 < 0.0 || between.norm() < kOnBorder) return;
  const Vec2 sideways = left_of(between.normalized()) * std::sqrt(half2);
  for (const double sign : {1.0, -1.0}) out.push_back(centre + 0.5 * between + sign * sideways);
}

/// Lines and circle centres at `clearance` to the walls.
struct Bounds {
  std::vector<Line> lines;
  std::vector<Vec2> centres;

  Bounds(std::span<const Wall> walls, const std::vector<std::uint32_t>& near, bool one_sided,
         double clearance) {
    for (const std::uint32_t index : near) {
      const Wall& wall = walls[index];
      const Vec2 along = (wall.b - wall.a).normalized();
      lines.push_back({wall.a + clearance * left_of(along), along});
      if (!one_sided) lines.push_back({wall.a - clearance * left_of(along), along});
      centres.push_back(wall.a);
      centres.push_back(wall.b);
    }
    const auto before = [](const Vec2& p, const Vec2& q) {
      return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
    };
    std::sort(centres.begin(), centres.end(), before);
    centres.erase(std::unique(centres.begin(), centres.end()), centres.end());
  }

  /// Feet of the perpendiculars from a point.
  void feet(const Vec2& point, double radius, std::vector<Vec2>& out) const {
    for (const Line& line : lines) {
      out.push_back(line.point + (point - line.point).dot(line.direction) * line.direction);
    }
    for (const Vec2& centre : centres) {
      const double distance = (point - centre).norm();
      if (distance > kOnBorder) out.push_back(centre + radius / distance * (point - centre));
    }
  }

  void crossings(double radius, std::vector<Vec2>& out) const {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (std::size_t j = i + 1; j < lines.size(); ++j) meet(lines[i], lines[j], out);
      for (const Vec2& centre : centres) meet(lines[i], centre, radius, out);
    }
    for (std::size_t i = 0; i < centres.size(); ++i) {
      for (std::size_t j = i + 1; j < centres.size(); ++j)
        meet(centres[i], centres[j], radius, out);
    }
  }
};

}  // namespace

bool WallIndex::has_room(const Vec2& point, double clearance) const {
  return inside(point) && room(point, clearance) >= clearance - kOnBorder;
}

std::optional<Vec2> WallIndex::nearest_with_room(const Vec2& point, double clearance, double reach,
                                                 bool in_sight) const {
  const double radius = clearance + kExtra;
  std::optional<Vec2> best;
  double nearest_yet = reach;
  std::vector<Vec2> places;
  const auto take_best = [&] {
    std::erase_if(places, [&](const Vec2& p) { return (p - point).norm() >= nearest_yet; });
    std::sort(places.begin(), places.end(), [&](const Vec2& p, const Vec2& q) {
      return (p - point).squaredNorm() < (q - point).squaredNorm();
    });
    for (const Vec2& place : places) {
      if (!has_room(place, clearance) || (in_sight && !sees(point, place))) continue;
      best = place;
      nearest_yet = (place - point).norm();
      break;
    }
    places.clear();
  };
  std::vector<std::uint32_t> walls;
  near(point, reach + radius, walls);
  Bounds(walls_, walls, bounded_, radius).feet(point, radius, places);
  take_best();
  // Only walls within the clearance of a nearer place can bound one.
  near(point, nearest_yet + radius, walls);
  Bounds(walls_, walls, bounded_, radius).crossings(radius, places);
  take_best();
  return best;
}

/// A place just inside, next to a place on the border.
Vec2 WallIndex::just_inside(const Nearest& place) const {
  std::vector<std::uint32_t> touching;
  near(place.point, kOnBorder, touching);
  Vec2 sum = Vec2::Zero();
  for (const std::uint32_t index : touching) {
    sum += left_of((walls_[index].b - walls_[index].a).normalized());
  }
  std::vector<Vec2> directions{sum};
  for (const std::uint32_t index : touching) {
    const Vec2 along = (walls_[index].b - walls_[index].a).normalized();
    for (const Vec2& side : {Vec2(along), Vec2(-along)})
      directions.push_back(left_of(along) + side);
    directions.push_back(left_of(along));
  }
  for (const Vec2& direction : directions) {
    if (direction.norm() < kOnBorder) continue;
    const Vec2 inner = place.point + kExtra * direction.normalized();
    if (inside(inner)) return inner;
  }
  return place.point;
}

Vec2 WallIndex::nearest_inside(const Vec2& point, double clearance) const {
  if (walls_.empty() || !(std::isfinite(point.x()) && std::isfinite(point.y()))) return point;
  clearance = std::max(0.0, clearance);
  if (has_room(point, clearance)) return point;
  const Nearest border = nearest_anywhere(point);
  const bool was_inside = inside(point);
  const double reach = border.distance + kSearchReach * clearance + 2.0 * kExtra;
  if (const auto place = nearest_with_room(point, clearance, reach, was_inside)) return *place;
  Vec2 place = was_inside ? point : just_inside(border);
  double step = kClimbShare * clearance;
  for (int climbs = 0; climbs < kMostClimbs && step > kExtra; ++climbs) {
    const Vec2 next = push_out(place, clearance, step);
    if (next == place) step *= 0.5;
    place = next;
  }
  return place;
}

}  // namespace pedzone
