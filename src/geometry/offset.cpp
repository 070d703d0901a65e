// Widened lines and grown or shrunk regions: unions of a quadrangle for each edge and a fan for
// each corner, or what is left when they are taken away.
//
//        ____________  fan at a corner that opens to this side
//       |  quad    |/\.
//   ----a----------b  |   shrinking takes the same pieces from the other side
//                   \ |
#include <algorithm>
#include <cmath>

#include "geometry/box_tree.hpp"
#include "geometry/overlay.hpp"
#include "geometry/polygon.hpp"

namespace pedzone {
namespace {

using overlay::Cover;
using overlay::Operation;

// numerical: how far a chord may stay inside the arc it stands for; halving it doubles the
// corners and moves the border by less than a coordinate of OSM is exact to.
constexpr double kChordError = 0.01;           // [m]
constexpr double kRelativeChordError = 0.005;  // of the radius
// numerical: shorter edges have no direction worth the name on a grid of 1 mm.
constexpr double kShortestEdge = 0.0015;  // [m]
constexpr double kSmallestTurn = 1e-6;    // [rad]

/// Points without repetitions.
std::vector<Vec2> distinct(const std::vector<Vec2>& points, bool closed) {
  std::vector<Vec2> out;
  for (const Vec2& point : points) {
    if (!std::isfinite(point.x()) || !std::isfinite(point.y())) continue;
    const Vec2 p = overlay::on_grid(point);
    if (out.empty() || (p - out.back()).norm() > kShortestEdge) out.push_back(p);
  }
  while (closed && out.size() > 1 && (out.front() - out.back()).norm() <= kShortestEdge) {
    out.pop_back();
  }
  return out;
}

double chord_angle(double radius) {
  const double error = std::max(kChordError, kRelativeChordError * radius);
  return 2.0 * std::acos(std::clamp(1.0 - error / radius, 0.0, 1.0));
}

/// Collects the pieces that lie within `radius` on one side of directed edges; with boxes only those
/// that meet one of them.
class Band {
 public:
  Band(Cover& out, double radius, Corners corners, const BoxTree* boxes = nullptr)
      : out_(out), radius_(radius), corners_(corners), boxes_(boxes) {}

  /// Adds the pieces to the right of a line or ring (to the left: negative `side`).
  void add(const std::vector<Vec2>& points, bool closed, double side) {
    const std::size_t count = points.size();
    if (count < 2) return;
    std::vector<Ring> rims(count);
    for (std::size_t i = closed ? 0 : 1; i < (closed ? count : count - 1); ++i) {
      rims[i] = rim(points[(i + count - 1) % count], points[i], points[(i + 1) % count], side);
      if (rims[i].size() < 2) continue;
      Ring fan = rims[i];
      fan.push_back(points[i]);
      add_piece(fan);
    }
    for (std::size_t i = 0; i < (closed ? count : count - 1); ++i) {
      const std::size_t j = (i + 1) % count;
      const Vec2 offset = outward(points[j] - points[i], side);
      const Vec2 start = rims[i].empty() ? Vec2(points[i] + offset) : rims[i].back();
      const Vec2 end = rims[j].empty() ? Vec2(points[j] + offset) : rims[j].front();
      add_piece({points[i], start, end, points[j]});
    }
  }

  /// ... of all rings of a region.
  void add(const Region& region, double side) {
    for (const Polygon& polygon : region) {
      add(distinct(polygon.outer, true), true, side);
      for (const Ring& hole : polygon.holes) add(distinct(hole, true), true, side);
    }
  }

 private:
  void add_piece(const Ring& piece) {
    if (boxes_ == nullptr || !boxes_->meeting(box_of(piece)).empty()) out_.add_simple(piece);
  }

  Vec2 outward(const Vec2& edge, double side) const {
    return -left_of(edge.normalized()) * (side * radius_);
  }

  /// The rim round b from the border beside a → b to the one beside b → c, where these gape.
  Ring rim(const Vec2& a, const Vec2& b, const Vec2& c, double side) const {
    const Vec2 in = b - a, out = c - b;
    const double turn = std::atan2(cross(in, out), in.dot(out));
    // A full turn back gapes on both sides.
    const bool back = kPi - std::abs(turn) < kSmallestTurn;
    if (!back && turn * side < kSmallestTurn) return {};
    const double sweep = side * std::abs(turn);
    const double start = angle_of(outward(in, side));
    Ring points;
    if (corners_ == Corners::kMitred) {
      // One point outside the circle for each quarter turn: its tangents keep the distance.
      const int count = static_cast<int>(std::ceil(std::abs(sweep) / (0.5 * kPi) - kSmallestTurn));
      const double part = sweep / count;
      const double reach = radius_ / std::cos(0.5 * part);
      for (int i = 0; i < count; ++i) points.push_back(b + unit(start + (i + 0.5) * part) * reach);
      return points;
    }
    const int count = static_cast<int>(std::ceil(std::abs(sweep) / chord_angle(radius_)));
    // A slight turn: one point as far outside the arc as a chord would be inside.
    if (count == 1) return {b + unit(start + 0.5 * sweep) * (radius_ / std::cos(0.5 * sweep))};
    points.push_back(b + outward(in, side));
    for (int i = 1; i < count; ++i) points.push_back(b + unit(start + sweep * i / count) * radius_);
    points.push_back(b + outward(out, side));
    return points;
  }

  Cover& out_;
  double radius_;
  Corners corners_;
  const BoxTree* boxes_;
};

}  // namespace

Region widen(const Polyline& line, double width) {
  const std::vector<Vec2> points = distinct(line, false);
  Cover pieces;
  if (width > 0.0) {
    Band band(pieces, 0.5 * width, Corners::kRound);
    for (const double side : {1.0, -1.0}) band.add(points, false, side);
  }
  return overlay::combine(pieces, Operation::kUnite, {});
}

Region grow(const Region& region, double distance, Corners corners) {
  if (!std::isfinite(distance) || distance == 0.0) return region;
  const double side = distance > 0.0 ? 1.0 : -1.0;
  Cover inside, pieces;
  inside.add(region);
  Band(pieces, std::abs(distance), corners).add(region, side);
  return overlay::combine(inside, distance > 0.0 ? Operation::kUnite : Operation::kSubtract,
                          pieces);
}

Region shrink_within(const Region& region, double distance, const Region& where) {
  if (where.empty()) return {};
  std::vector<Box> boxes;
  for (const Polygon& polygon : where) boxes.push_back(box_of(polygon.outer));
  const BoxTree places(boxes);
  Cover inside, pieces;
  inside.add(region);
  Band(pieces, distance, Corners::kRound, &places).add(region, -1.0);
  return intersect(overlay::combine(inside, Operation::kSubtract, pieces), where);
}

}  // namespace pedzone
