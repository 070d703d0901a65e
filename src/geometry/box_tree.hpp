// Boxes by place, by Boost.Geometry's R-tree.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/box.hpp"

namespace pedzone {

class BoxTree {
 public:
  /// Empty boxes meet nothing.
  explicit BoxTree(const std::vector<Box>& boxes);
  ~BoxTree();

  /// Places in the list of those that meet `box`, borders included, in ascending order.
  std::vector<std::size_t> meeting(const Box& box) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace pedzone
