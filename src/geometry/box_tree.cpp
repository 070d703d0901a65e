#include "geometry/box_tree.hpp"

#include <algorithm>
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <utility>

namespace pedzone {
namespace {

namespace bg = boost::geometry;
using Corner = bg::model::point<double, 2, bg::cs::cartesian>;
using TreeBox = bg::model::box<Corner>;
using Entry = std::pair<TreeBox, std::size_t>;

constexpr std::size_t kNodeSize = 16;  // numerical: Boost's own example

TreeBox as_tree_box(const Box& box) {
  return {{box.min().x(), box.min().y()}, {box.max().x(), box.max().y()}};
}

std::vector<Entry> entries_of(const std::vector<Box>& boxes) {
  std::vector<Entry> entries;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!boxes[k].isEmpty()) entries.emplace_back(as_tree_box(boxes[k]), k);
  }
  return entries;
}

}  // namespace

struct BoxTree::Tree {
  bg::index::rtree<Entry, bg::index::rstar<kNodeSize>> entries;
};

BoxTree::BoxTree(const std::vector<Box>& boxes)
    : tree_(new Tree{decltype(Tree::entries)(entries_of(boxes))}) {}
BoxTree::~BoxTree() = default;

std::vector<std::size_t> BoxTree::meeting(const Box& box) const {
  std::vector<std::size_t> found;
  if (box.isEmpty()) return found;
  for (auto it = tree_->entries.qbegin(bg::index::intersects(as_tree_box(box)));
       it != tree_->entries.qend(); ++it) {
    found.push_back(it->second);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace pedzone
