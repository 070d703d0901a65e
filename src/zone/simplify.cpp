#include "zone/simplify.hpp"

#include <cstddef>

#include "zone/shapes.hpp"

namespace pedzone {
namespace {

class Simplifier {
 public:
  Simplifier(const std::vector<Vec2>& points, double tolerance)
      : points_(points), tolerance_(tolerance), keep_(points.size(), false) {}

  Ring ring() {
    // A ring is two lines between its first point and the one farthest from it.
    std::size_t far = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      if ((points_[i] - points_[0]).squaredNorm() > (points_[far] - points_[0]).squaredNorm()) {
        far = i;
      }
    }
    keep_[0] = keep_[far] = true;
    split(0, far);
    split(far, points_.size());
    return kept();
  }

  Polyline line() {
    keep_.front() = keep_.back() = true;
    split(0, points_.size() - 1);
    return kept();
  }

 private:
  /// Keeps what the line from `first` to `last` (the number of points stands for the first of a
  /// ring) needs. A stack instead of recursion: borders of towns have thousands of points.
  void split(std::size_t first, std::size_t last) {
    std::vector<std::pair<std::size_t, std::size_t>> stack{{first, last}};
    while (!stack.empty()) {
      const auto [from, to] = stack.back();
      stack.pop_back();
      const Vec2 &a = points_[from], &b = points_[to % points_.size()];
      double most = tolerance_;
      std::size_t corner = from;
      for (std::size_t i = from + 1; i < to; ++i) {
        const double distance = (points_[i] - a - (b - a) * nearest_part(a, b, points_[i])).norm();
        if (distance <= most) continue;
        most = distance;
        corner = i;
      }
      if (corner == from) continue;
      keep_[corner] = true;
      stack.push_back({from, corner});
      stack.push_back({corner, to});
    }
  }

  std::vector<Vec2> kept() const {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (keep_[i]) points.push_back(points_[i]);
    }
    return points;
  }

  const std::vector<Vec2>& points_;
  double tolerance_;
  std::vector<bool> keep_;
};

}  // namespace

Region simplified(const Region& region, double tolerance) {
  Region result;
  for (const Polygon& polygon : region) {
    Polygon& simple = result.emplace_back();
    simple.outer = Simplifier(polygon.outer, tolerance).ring();
    for (const Ring& hole : polygon.holes) {
      simple.holes.push_back(Simplifier(hole, tolerance).ring());
    }
  }
  // Lines that pass close to each other may cross now.
  return make_valid(result);
}

Polyline simplified(const Polyline& line, double tolerance) {
  return line.size() < 3 ? line : Simplifier(line, tolerance).line();
}

}  // namespace pedzone
