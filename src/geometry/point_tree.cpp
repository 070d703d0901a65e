#include "geometry/point_tree.hpp"

#include <algorithm>

namespace pedzone {
namespace {

constexpr std::uint32_t kMost = 8;  // numerical, by timing: points in a box that has none in it

}  // namespace

PointTree::PointTree(std::span<const Vec2> points) {
  for (const Vec2& point : points) {
    points_.push_back({point, static_cast<std::uint32_t>(points_.size())});
  }
  if (!points_.empty()) add(0, static_cast<std::uint32_t>(points_.size()));
}

/// Halves a box of more than kMost points across its longer side.
void PointTree::add(std::uint32_t first, std::uint32_t last) {
  const std::size_t own = nodes_.size();
  Node node{points_[first].place, points_[first].place};
  for (std::uint32_t p = first; p < last; ++p) {
    node.low = node.low.cwiseMin(points_[p].place);
    node.high = node.high.cwiseMax(points_[p].place);
  }
  if (last - first <= kMost) {
    node.first = first;
    node.last = last;
  }
  nodes_.push_back(node);
  if (last - first > kMost) {
    const Vec2 size = node.high - node.low;
    const int axis = size.x() < size.y() ? 1 : 0;
    const std::uint32_t middle = first + (last - first) / 2;
    const auto begin = points_.begin();
    std::nth_element(begin + first, begin + middle, begin + last,
                     [&](const Point& a, const Point& b) { return a.place[axis] < b.place[axis]; });
    add(first, middle);
    add(middle, last);
  }
  nodes_[own].behind = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace pedzone
