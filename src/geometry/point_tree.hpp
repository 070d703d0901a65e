// Points in boxes within boxes: what near walls hide is passed over by the box.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/outlook.hpp"

namespace pedzone {

class PointTree {
 public:
  PointTree() = default;
  /// Takes in the points [m], all finite.
  explicit PointTree(std::span<const Vec2> points);

  /// Calls visit(index of the point, its offset from `from` [m]) for all that the outlook from
  /// there does not hide, in no order that means anything.
  template <class Visit>
  void visit_in_view(const Outlook& outlook, const Vec2& from, Visit visit) const {
    for (std::uint32_t k = 0; k < nodes_.size();) {
      const Node& node = nodes_[k];
      if (outlook.hides_box(node.low - from, node.high - from)) {
        k = node.behind;
        continue;
      }
      for (std::uint32_t p = node.first; p < node.last; ++p) {
        const Vec2 offset = points_[p].place - from;
        if (!outlook.hides(offset)) visit(points_[p].index, offset);
      }
      ++k;
    }
  }

 private:
  struct Point {
    Vec2 place;
    std::uint32_t index;
  };
  /// A box and the points in it; none of its own where it has boxes in it, which follow it.
  struct Node {
    Vec2 low, high;  ///< corners [m]
    std::uint32_t first = 0, last = 0;
    std::uint32_t behind = 0;  ///< the node after all that are in it
  };

  void add(std::uint32_t first, std::uint32_t last);

  std::vector<Point> points_;
  std::vector<Node> nodes_;
};

}  // namespace pedzone
