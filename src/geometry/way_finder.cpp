// A shortest path turns at corners that stick out into the walkable area only, and lies tight
// round them: a line that would leave a corner's two walls on different sides can be cut short.
// So the graph has an edge for each pair of such corners that see each other along a line that is
// tight at both. Start and goal are linked during the search, and only where it comes to them:
// links go into the queue unchecked and are looked at when they are the shortest left.
#include "geometry/way_finder.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include "geometry/body_room.hpp"
#include "geometry/outlook.hpp"

namespace pedzone {
namespace {

// assumed: half the width of the narrowest passage that people use (a body's half width).
constexpr double kLeastRoom = 0.2;  // [m]
// numerical: start and goal are this far inside the shrunk area, so that lines of sight from them
// do not run in its border.
constexpr double kOffBorder = 1e-4;  // [m]
// numerical: sine of the angle by which a line may miss being tight; corners on a grid of 1 mm
// that are in line are so to about this much.
constexpr double kTaut = 1e-6;

}  // namespace

WayFinder::WayFinder(const Region& walkable, double clearance)
    : clearance_(clearance), area_(walkable) {
  const Region room = body_room(walkable, clearance, kLeastRoom);
  walls_ = WallIndex(room);
  for (std::size_t i = 0; i < room.size(); ++i) {
    add_corners(room[i].outer, static_cast<int>(i));
    for (const Ring& hole : room[i].holes) add_corners(hole, static_cast<int>(i));
  }
  link_corners();
}

void WayFinder::add_corners(const Ring& ring, int component) {
  const std::size_t count = ring.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 before = ring[(i + count - 1) % count] - ring[i];
    const Vec2 after = ring[(i + 1) % count] - ring[i];
    if (cross(-before, after) >= 0.0) continue;  // the area is to the left
    nodes_.push_back({ring[i], before.normalized(), after.normalized(), component, {}});
  }
}

void WayFinder::link_corners() {
  std::vector<Vec2> points;  // close together: of most pairs no more is read
  for (const Node& node : nodes_) points.push_back(node.point);
  Outlook outlook;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    outlook.look(walls_, points[i]);
    for (std::size_t j = i + 1; j < nodes_.size(); ++j) {
      const Vec2 line = points[j] - points[i];
      if (outlook.hides(line)) continue;
      Node &u = nodes_[i], &v = nodes_[j];
      if (u.component != v.component) continue;
      if (!is_taut(u, line) || !is_taut(v, line) || !walls_.sees(u.point, v.point)) continue;
      u.edges.emplace_back(static_cast<int>(j), line.norm());
      v.edges.emplace_back(static_cast<int>(i), line.norm());
    }
  }
}

/// Whether both walls of a corner are on the same side of a line through it.
bool WayFinder::is_taut(const Node& node, const Vec2& direction) {
  const double before = cross(direction, node.before), after = cross(direction, node.after);
  const double slack = kTaut * direction.norm();
  return std::min(before, after) >= -slack || std::max(before, after) <= slack;
}

/// The place from which or to which a way can lead.
Vec2 WayFinder::place_near(const Vec2& point) const {
  const Vec2 place = walls_.nearest_inside(point, kOffBorder);
  if (place == point || !area_.inside(point) || area_.sees(point, place)) return place;
  // The nearest one is behind a wall: first to the middle of what room there is here.
  return walls_.nearest_inside(area_.nearest_inside(point, clearance_), kOffBorder);
}

/// One A* search.
class WayFinder::Search {
 public:
  Search(const WayFinder& finder, const Vec2& from, const Vec2& to)
      : finder_(finder),
        from_(from),
        to_(to),
        goal_(static_cast<int>(finder.nodes_.size())),
        parent_(finder.nodes_.size(), kStart),
        length_(finder.nodes_.size(), std::numeric_limits<double>::infinity()),
        done_(finder.nodes_.size(), 0) {}

  std::optional<Polyline> run() {
    if (finder_.walls_.sees(from_, to_)) return Polyline{to_};
    link_start();
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (entry.node == goal_) {
        if (finder_.walls_.sees(node(entry.parent).point, to_)) return path_to(entry.parent);
        continue;
      }
      if (done_[entry.node]) continue;
      if (entry.parent == kStart && !finder_.walls_.sees(from_, node(entry.node).point)) continue;
      done_[entry.node] = 1;
      length_[entry.node] = entry.length;
      parent_[entry.node] = entry.parent;
      expand(entry.node);
    }
    return std::nullopt;
  }

 private:
  static constexpr int kStart = -1;

  struct Entry {
    double estimate;  ///< [m] of the whole way
    double length;    ///< [m] up to the node
    int node, parent;
    /// Shorter ones first, then by number: the same way on every machine.
    bool operator<(const Entry& other) const {
      return std::tie(other.estimate, other.node, other.parent) < std::tie(estimate, node, parent);
    }
  };

  const Node& node(int index) const { return finder_.nodes_[index]; }

  void push(int index, int parent, double length) {
    queue_.push({length + (to_ - node(index).point).norm(), length, index, parent});
  }

  void link_start() {
    for (int i = 0; i < goal_; ++i) {
      const Vec2 line = node(i).point - from_;
      if (is_taut(node(i), line)) push(i, kStart, line.norm());
    }
  }

  void expand(int index) {
    const Node& here = node(index);
    for (const auto& [next, length] : here.edges) {
      const double total = length_[index] + length;
      if (done_[next] || total >= length_[next]) continue;
      length_[next] = total;
      push(next, index, total);
    }
    const Vec2 line = to_ - here.point;
    if (is_taut(here, line)) {
      const double total = length_[index] + line.norm();
      queue_.push({total, total, goal_, index});
    }
  }

  Polyline path_to(int last) const {
    Polyline path{to_};
    for (int index = last; index != kStart; index = parent_[index]) {
      path.push_back(node(index).point);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  const WayFinder& finder_;
  Vec2 from_, to_;
  int goal_;
  std::vector<int> parent_;
  std::vector<double> length_;
  std::vector<char> done_;
  std::priority_queue<Entry> queue_;
};

std::optional<Polyline> WayFinder::way(const Vec2& from, const Vec2& to) const {
  if (walls_.walls().empty() || !from.allFinite() || !to.allFinite()) return std::nullopt;
  const Vec2 start = place_near(from), goal = place_near(to);
  std::optional<Polyline> path = Search(*this, start, goal).run();
  if (path && start != from && !(area_.inside(from) && area_.sees(from, path->front()))) {
    path->insert(path->begin(), start);
  }
  return path;
}

double WayFinder::distance(const Vec2& from, const Vec2& to) const {
  const std::optional<Polyline> path = way(from, to);
  if (!path) return std::numeric_limits<double>::infinity();
  double length = 0.0;
  const Vec2* last = &from;
  for (const Vec2& point : *path) {
    length += (point - *last).norm();
    last = &point;
  }
  return length;
}

}  // namespace pedzone
