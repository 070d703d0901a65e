// Narrow passages are found as pairs of walls that face each other across walkable space:
//
//   ____________a_________b______      both walls' parts that are within reach of the other one
//               .  narrow .            (a – b and c – d) and a margin round them, which leads into
//   ------------c---------d------      the area with full room on either end
//
// Shrinking less everywhere would do for connectivity, but ways would keep less distance at every
// corner.
#include "geometry/body_room.hpp"

#include <algorithm>
#include <array>

#include "geometry/segment.hpp"
#include "geometry/wall_index.hpp"

namespace pedzone {
namespace {

// numerical: the zone round a narrow place, in clearances: more than one, so that it overlaps the
// area with full room; it matters for a few decimetres of way only.
constexpr double kMargin = 1.5;
// How much farther than the clearance a mitred right angle reaches.
constexpr double kMitre = std::numbers::sqrt2;
// Walls at less than 60° to each other face each other; wider ones are corners of a room.
constexpr double kFacing = -0.5;
constexpr double kTouch = 1e-6;    // [m] numerical: the same place
constexpr int kMarginCorners = 8;  // numerical: of the polygon that stands for a disc
constexpr int kBisections = 40;    // numerical: halvings; exact to rounding

struct Pair {
  Vec2 p, q;  ///< nearest places of two walls
};

Pair nearest_pair(const Wall& v, const Wall& w) {
  const std::array<Pair, 4> ends{{{v.a, nearest_on(w.a, w.b, v.a)},
                                  {v.b, nearest_on(w.a, w.b, v.b)},
                                  {nearest_on(v.a, v.b, w.a), w.a},
                                  {nearest_on(v.a, v.b, w.b), w.b}}};
  return *std::min_element(ends.begin(), ends.end(), [](const Pair& s, const Pair& t) {
    return (s.q - s.p).squaredNorm() < (t.q - t.p).squaredNorm();
  });
}

Vec2 inward(const Wall& wall) { return left_of((wall.b - wall.a).normalized()); }

/// From `near`, which is within `reach` of the other wall, as far towards `end` as that holds.
Vec2 last_within(const Vec2& near, const Vec2& end, const Wall& other, double reach) {
  const auto within = [&](const Vec2& point) {
    return (nearest_on(other.a, other.b, point) - point).norm() <= reach;
  };
  if (within(end)) return end;
  double low = 0.0, high = 1.0;  // the distance to a segment is convex along a line
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (within(near + middle * (end - near)) ? low : high) = middle;
  }
  return near + low * (end - near);
}

/// Convex hull, counter-clockwise.
Ring hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& p, const Vec2& q) {
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  });
  Ring ring;
  const auto add = [&](const Vec2& point, std::size_t kept) {
    while (ring.size() >= kept + 2 &&
           cross(ring.back() - ring[ring.size() - 2], point - ring.back()) <= 0.0) {
      ring.pop_back();
    }
    ring.push_back(point);
  };
  for (const Vec2& point : points) add(point, 0);
  const std::size_t lower = ring.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) add(*point, lower);
  ring.pop_back();
  return ring;
}

/// The hull of discs round some points.
Region zone_round(const std::array<Vec2, 4>& points, double radius) {
  std::vector<Vec2> corners;
  for (const Vec2& point : points) {
    for (int i = 0; i < kMarginCorners; ++i) {
      corners.push_back(point + radius * unit(2.0 * kPi * i / kMarginCorners));
    }
  }
  return {{hull(std::move(corners)), {}}};
}

class NarrowPlaces {
 public:
  explicit NarrowPlaces(const Region& walkable) : index_(walkable) {}

  /// Round all passages narrower than `width` [m].
  std::vector<Region> zones(double margin, double width) const {
    std::vector<Region> zones;
    std::vector<std::uint32_t> others;
    const auto walls = index_.walls();
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
      const double half = 0.5 * (walls[i].b - walls[i].a).norm();
      index_.near(0.5 * (walls[i].a + walls[i].b), half + width, others);
      for (const std::uint32_t j : others) {
        if (j <= i) continue;
        const Pair pair = nearest_pair(walls[i], walls[j]);
        if (!is_passage(walls[i], walls[j], pair, width)) continue;
        zones.push_back(zone_round({last_within(pair.p, walls[i].a, walls[j], width),
                                    last_within(pair.p, walls[i].b, walls[j], width),
                                    last_within(pair.q, walls[j].a, walls[i], width),
                                    last_within(pair.q, walls[j].b, walls[i], width)},
                                   margin));
      }
    }
    return zones;
  }

 private:
  /// Whether what is between the two places is walkable and narrow.
  bool is_passage(const Wall& v, const Wall& w, const Pair& pair, double width) const {
    const Vec2 between = pair.q - pair.p;
    const double gap = between.norm();
    if (gap >= width || gap <= kTouch) return false;
    if (inward(v).dot(between) < -kTouch || inward(w).dot(between) > kTouch) return false;
    const bool facing = inward(v).dot(inward(w)) < kFacing;
    if (!facing && !(no_nearer(pair.p, between) && no_nearer(pair.q, -between))) return false;
    return index_.inside(0.5 * (pair.p + pair.q)) && index_.sees(pair.p, pair.q);
  }

  /// Whether no border from `place` leads towards the other side.
  bool no_nearer(const Vec2& place, const Vec2& between) const {
    std::vector<std::uint32_t> touching;
    index_.near(place, kTouch, touching);
    return std::ranges::all_of(touching, [&](std::uint32_t index) {
      const Wall& wall = index_.walls()[index];
      const bool at_a = (wall.a - place).norm() <= kTouch, at_b = (wall.b - place).norm() <= kTouch;
      if (!at_a && !at_b) return true;
      return (at_a ? wall.b - place : wall.a - place).dot(between) <= kTouch;
    });
  }

  WallIndex index_;
};

}  // namespace

Region body_room(const Region& walkable, double clearance, double least) {
  const NarrowPlaces narrow(walkable);
  const double margin = kMargin * clearance;
  std::vector<Region> rooms{grow(walkable, -clearance, Corners::kMitred)};
  const auto add = [&](double shrunk_by, double width) {
    const std::vector<Region> zones = narrow.zones(margin, width);
    if (!zones.empty()) rooms.push_back(shrink_within(walkable, shrunk_by, unite(zones)));
  };
  // Mitres reach farther than the clearance: two of them may close what is wide enough.
  add(clearance, kMitre * 2.0 * clearance);
  if (clearance > least) add(least, 2.0 * clearance);
  return rooms.size() == 1 ? rooms.front() : unite(rooms);
}

}  // namespace pedzone
