// Widened lines and grown or shrunk regions: unions of a quadrangle for each edge and a fan for
// each corner, or what is left when they are taken away.
//
//        ____________  fan at a corner that opens to this side
//       |  quad    |/\.
//   ----a----------b  |   shrinking takes the same pieces from the other side
//                   \ |
#include <algorithm>
#include <cmath>

#include "geometry/overlay.hpp"
#include "geometry/polygon.hpp"

namespace pedzone {
namespace {

using overlay::Overlay;
using overlay::Winding;
using Operand = Overlay::Operand;

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
    const Vec2 p = overlay::from_grid(overlay::to_grid(point));
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

/// Collects the pieces that lie within `radius` on one side of directed edges.
class Band {
 public:
  Band(Overlay& out, double radius, Corners corners)
      : out_(out), radius_(radius), corners_(corners) {}

  /// The quadrangle to the right of a → b (left: negative `side`).
  void edge(const Vec2& a, const Vec2& b, double side) {
    const Vec2 offset = -left_of((b - a).normalized()) * (side * radius_);
    out_.add_turned({a, a + offset, b + offset, b}, Operand::kB, false);
  }

  /// The fan at b between the quadrangles of a → b and b → c where they gape.
  void corner(const Vec2& a, const Vec2& b, const Vec2& c, double side) {
    const Vec2 in = (b - a).normalized(), out = (c - b).normalized();
    const double turn = std::atan2(cross(in, out), in.dot(out));
    // A full turn back gapes on both sides.
    const bool back = kPi - std::abs(turn) < kSmallestTurn;
    if (!back && turn * side < kSmallestTurn) return;
    const double sweep = side * std::abs(turn);
    const double start = angle_of(-left_of(in) * side);
    Ring fan{b, b - left_of(in) * (side * radius_)};
    arc(b, start, sweep, fan);
    fan.push_back(b - left_of(out) * (side * radius_));
    out_.add_turned(fan, Operand::kB, false);
  }

 private:
  void arc(const Vec2& centre, double start, double sweep, Ring& fan) const {
    if (corners_ == Corners::kMitred) {
      // One point outside the circle for each quarter turn: its tangents keep the distance.
      const int count = static_cast<int>(std::ceil(std::abs(sweep) / (0.5 * kPi) - kSmallestTurn));
      const double part = sweep / count;
      const double reach = radius_ / std::cos(0.5 * part);
      for (int i = 0; i < count; ++i)
        fan.push_back(centre + unit(start + (i + 0.5) * part) * reach);
      return;
    }
    const int count = static_cast<int>(std::ceil(std::abs(sweep) / chord_angle(radius_)));
    for (int i = 1; i < count; ++i)
      fan.push_back(centre + unit(start + sweep * i / count) * radius_);
  }

  Overlay& out_;
  double radius_;
  Corners corners_;
};

void add_band(const Ring& ring, double side, Band& band) {
  const std::vector<Vec2> points = distinct(ring, true);
  const std::size_t count = points.size();
  if (count < 2) return;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 &a = points[i], &b = points[(i + 1) % count], &c = points[(i + 2) % count];
    band.edge(a, b, side);
    band.corner(a, b, c, side);
  }
}

}  // namespace

Region widen(const Polyline& line, double width) {
  const std::vector<Vec2> points = distinct(line, false);
  Overlay pieces;
  if (width > 0.0) {
    Band band(pieces, 0.5 * width, Corners::kRound);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      for (const double side : {1.0, -1.0}) {
        band.edge(points[i], points[i + 1], side);
        if (i + 2 < points.size()) band.corner(points[i], points[i + 1], points[i + 2], side);
      }
    }
  }
  const Region region = pieces.result([](const Winding& w) { return w.b != 0; });
  return unite(region, {});
}

Region grow(const Region& region, double distance, Corners corners) {
  if (!std::isfinite(distance) || distance == 0.0) return unite(region, {});
  const Region valid = unite(region, {});
  Overlay overlay;
  overlay.add(valid, Operand::kA);
  const double side = distance > 0.0 ? 1.0 : -1.0;
  Band band(overlay, std::abs(distance), corners);
  for (const Polygon& polygon : valid) {
    add_band(polygon.outer, side, band);
    for (const Ring& hole : polygon.holes) add_band(hole, side, band);
  }
  const Region result = distance > 0.0
                            ? overlay.result([](const Winding& w) { return w.a != 0 || w.b != 0; })
                            : overlay.result([](const Winding& w) { return w.a != 0 && w.b == 0; });
  return unite(result, {});
}

}  // namespace pedzone
