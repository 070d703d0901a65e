#include "zone/simplify.hpp"

#include <cstddef>

#include "zone/shapes.hpp"

namespace pedzone {
namespace {

class RingSimplifier {
 public:
  RingSimplifier(const Ring& ring, double tolerance)
      : ring_(ring), tolerance_(tolerance), keep_(ring.size(), false) {}

  Ring result() {
    // A ring is two lines between its first point and the one farthest from it.
    std::size_t far = 0;
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      if ((ring_[i] - ring_[0]).squaredNorm() > (ring_[far] - ring_[0]).squaredNorm()) far = i;
    }
    keep_[0] = keep_[far] = true;
    split(0, far);
    split(far, ring_.size());
    Ring kept;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (keep_[i]) kept.push_back(ring_[i]);
    }
    return kept;
  }

 private:
  /// Keeps what the line from `first` to `last` (the ring's size stands for its first point)
  /// needs. A stack instead of recursion: borders of towns have thousands of points.
  void split(std::size_t first, std::size_t last) {
    std::vector<std::pair<std::size_t, std::size_t>> stack{{first, last}};
    while (!stack.empty()) {
      const auto [from, to] = stack.back();
      stack.pop_back();
      const Vec2 &a = ring_[from], &b = ring_[to % ring_.size()];
      double most = tolerance_;
      std::size_t corner = from;
      for (std::size_t i = from + 1; i < to; ++i) {
        const double distance = (ring_[i] - a - (b - a) * nearest_part(a, b, ring_[i])).norm();
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

  const Ring& ring_;
  double tolerance_;
  std::vector<bool> keep_;
};

}  // namespace

Region simplified(const Region& region, double tolerance) {
  Region result;
  for (const Polygon& polygon : region) {
    Polygon& simple = result.emplace_back();
    simple.outer = RingSimplifier(polygon.outer, tolerance).result();
    for (const Ring& hole : polygon.holes) {
      simple.holes.push_back(RingSimplifier(hole, tolerance).result());
    }
  }
  // Lines that pass close to each other may cross now.
  return unite(result, {});
}

}  // namespace pedzone
