// A shortest path turns at corners that stick out into the walkable area only, and lies tight
// round them: a line that would leave a corner's two walls on different sides can be cut short.
// So the graph has an edge for each pair of such corners that see each other along a line that is
// tight at both. Start and goals are linked during the search: links go into the queue unless near
// walls hide them, and are looked at when they are the shortest left.
#include "geometry/way_finder.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include "geometry/body_room.hpp"
#include "geometry/outlook.hpp"
#include "geometry/segment.hpp"

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
constexpr double kSamePlace = 0.5;  // [m] numerical: goals nearer than this are one

}  // namespace

WayFinder::WayFinder(const Region& walkable, double clearance)
    : clearance_(clearance), area_(walkable) {
  const Region room = body_room(walkable, clearance, kLeastRoom);
  walls_ = WallIndex(room);
  for (std::size_t i = 0; i < room.size(); ++i) add_part(room[i], static_cast<int>(i));
  link_corners();
}

void WayFinder::add_part(const Polygon& polygon, int part) {
  std::size_t walls = polygon.outer.size();
  add_corners(polygon.outer, part);
  for (const Ring& hole : polygon.holes) {
    walls += hole.size();
    add_corners(hole, part);
  }
  part_of_wall_.insert(part_of_wall_.end(), walls, part);
}

void WayFinder::add_corners(const Ring& ring, int part) {
  const std::size_t count = ring.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 before = ring[(i + count - 1) % count] - ring[i];
    const Vec2 after = ring[(i + 1) % count] - ring[i];
    if (cross(-before, after) >= 0.0) continue;  // the area is to the left
    nodes_.push_back({ring[i], before.normalized(), after.normalized(), part, {}});
  }
}

void WayFinder::link_corners() {
  std::vector<Vec2> points;
  for (const Node& node : nodes_) points.push_back(node.point);
  corners_ = PointTree(points);
  Outlook outlook;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    outlook.look(walls_, node.point);
    // Between its walls, and opposite, no line is tight.
    outlook.hide_between(node.before, node.after);
    outlook.hide_between(-node.before, -node.after);
    corners_.visit_in_view(outlook, node.point, [&](std::uint32_t j, const Vec2& line) {
      if (j > i) link(i, j, line);
    });
  }
  for (Node& node : nodes_) std::ranges::sort(node.edges);
}

/// Links two corners that see each other along a `line` that is tight at both.
void WayFinder::link(std::uint32_t i, std::uint32_t j, const Vec2& line) {
  Node &u = nodes_[i], &v = nodes_[j];
  if (u.part != v.part) return;
  if (!is_taut(u, line) || !is_taut(v, line) || !walls_.sees(u.point, v.point)) return;
  u.edges.emplace_back(static_cast<int>(j), line.norm());
  v.edges.emplace_back(static_cast<int>(i), line.norm());
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

/// The part of the area that a place is on: that of the wall nearest to it.
int WayFinder::part_of(const Vec2& place) const {
  return part_of_wall_[walls_.nearest_wall(place)];
}

/// One A* search, to the nearest of some places and of a line between two of them.
class WayFinder::Search {
 public:
  /// `goals`: not empty.
  Search(const WayFinder& finder, const Vec2& from, const Vec2& a, const Vec2& b,
         std::vector<Vec2> goals)
      : finder_(finder),
        from_(from),
        a_(a),
        b_(b),
        goals_(std::move(goals)),
        first_goal_(static_cast<int>(finder.nodes_.size())),
        on_line_(first_goal_ + static_cast<int>(goals_.size())),
        parent_(finder.nodes_.size(), kStart),
        length_(finder.nodes_.size(), std::numeric_limits<double>::infinity()),
        done_(finder.nodes_.size(), 0) {}

  std::optional<Polyline> run() {
    if (finder_.walls_.sees(from_, goals_.front())) return Polyline{goals_.front()};
    link_start();
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (entry.node < first_goal_ && done_[entry.node]) continue;
      const bool unchecked = entry.node >= first_goal_ || entry.parent == kStart;
      if (unchecked && !finder_.walls_.sees(point_of(entry.parent), point_of(entry))) continue;
      if (entry.node >= first_goal_) return path_to(entry);
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

  Vec2 point_of(int index) const { return index == kStart ? from_ : node(index).point; }

  Vec2 point_of(const Entry& entry) const {
    if (entry.node < first_goal_) return node(entry.node).point;
    if (entry.node < on_line_) return goals_[entry.node - first_goal_];
    return nearest_on(a_, b_, point_of(entry.parent));
  }

  /// [m] No way to any goal is shorter.
  double at_least(const Vec2& point) const {
    double least = (nearest_on(a_, b_, point) - point).squaredNorm();
    for (const Vec2& goal : goals_) least = std::min(least, (goal - point).squaredNorm());
    return std::sqrt(least);
  }

  void push(int index, int parent, double length) {
    queue_.push({length + at_least(node(index).point), length, index, parent});
  }

  void link_start() {
    Outlook outlook;
    outlook.look(finder_.walls_, from_);
    finder_.corners_.visit_in_view(outlook, from_, [&](std::uint32_t k, const Vec2& line) {
      const int i = static_cast<int>(k);
      if (is_taut(node(i), line)) push(i, kStart, line.norm());
    });
    for (std::size_t k = 1; k < goals_.size(); ++k) link_goal(k, kStart, 0.0);
  }

  void link_goal(std::size_t k, int parent, double length) {
    const double total = length + (goals_[k] - point_of(parent)).norm();
    queue_.push({total, total, first_goal_ + static_cast<int>(k), parent});
  }

  void expand(int index) {
    const Node& here = node(index);
    for (const auto& [next, length] : here.edges) {
      const double total = length_[index] + length;
      if (done_[next] || total >= length_[next]) continue;
      length_[next] = total;
      push(next, index, total);
    }
    for (std::size_t k = 0; k < goals_.size(); ++k) {
      if (is_taut(here, goals_[k] - here.point)) link_goal(k, index, length_[index]);
    }
    const Vec2 line = nearest_on(a_, b_, here.point) - here.point;
    if (goals_.size() > 1 && is_taut(here, line)) {
      const double total = length_[index] + line.norm();
      queue_.push({total, total, on_line_, index});
    }
  }

  Polyline path_to(const Entry& goal) const {
    Polyline path{point_of(goal)};
    for (int index = goal.parent; index != kStart; index = parent_[index]) {
      path.push_back(node(index).point);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  const WayFinder& finder_;
  Vec2 from_, a_, b_;
  std::vector<Vec2> goals_;
  int first_goal_, on_line_;  ///< stand for the goals and the line's nearest point, after the nodes
  std::vector<int> parent_;
  std::vector<double> length_;
  std::vector<char> done_;
  std::priority_queue<Entry> queue_;
};

std::optional<Polyline> WayFinder::way(const Vec2& from, const Vec2& to) const {
  return way_to_line(from, to, to);
}

std::optional<Polyline> WayFinder::way_to_line(const Vec2& from, const Vec2& a,
                                               const Vec2& b) const {
  const bool finite = from.allFinite() && a.allFinite() && b.allFinite();
  if (walls_.walls().empty() || !finite) return std::nullopt;
  const Vec2 start = place_near(from), first = place_near(a);
  const Vec2 second = a == b ? first : place_near(b);
  std::vector<Vec2> places{first};
  if (a != b) {
    places = {place_near(nearest_on(a, b, from)), place_near(0.5 * (a + b)), first, second};
  }
  const int part = part_of(start);
  std::vector<Vec2> goals;
  for (const Vec2& place : places) {
    const bool known = std::ranges::any_of(
        goals, [&](const Vec2& goal) { return (goal - place).norm() < kSamePlace; });
    if (!known && part_of(place) == part) goals.push_back(place);
  }
  if (goals.empty()) return std::nullopt;
  std::optional<Polyline> path = Search(*this, start, first, second, std::move(goals)).run();
  if (path && start != from && !(area_.inside(from) && area_.sees(from, path->front()))) {
    path->insert(path->begin(), start);
  }
  return path;
}

bool WayFinder::has_way(const Vec2& from, const Vec2& to) const {
  if (walls_.walls().empty() || !from.allFinite() || !to.allFinite()) return false;
  return part_of(place_near(from)) == part_of(place_near(to));
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
