// Shortest paths round obstacles with room for the body: a visibility graph over the corners of
// the walkable area shrunk by a clearance, computed once, queried fast.
#pragma once

#include <optional>
#include <vector>

#include "geometry/point_tree.hpp"
#include "geometry/wall_index.hpp"

namespace pedzone {

class WayFinder {
 public:
  WayFinder() = default;
  /// `clearance` [m] (0, 1]: kept to walls at corners; where a passage is narrower but still
  /// passable (wider than 2·0.2 m) it stays passable.
  WayFinder(const Region& walkable, double clearance);

  /// The points to head for in turn, `to` last (`from` not included): a shortest path.
  /// `from` and `to` are first moved to the nearest place with clearance where they have none;
  /// where the way on cannot be seen from `from` itself, that place is the first point.
  /// Nothing when no way exists. Const and safe from many threads.
  std::optional<Polyline> way(const Vec2& from, const Vec2& to) const;

  /// A way to the line a–b: no longer than those to its ends, to its middle, to its point nearest
  /// to `from`, and to its point nearest to where the way turns last (as far as it is in view from
  /// there). As way() otherwise.
  std::optional<Polyline> way_to_line(const Vec2& from, const Vec2& a, const Vec2& b) const;

  /// Whether way() finds one, without looking for it.
  bool has_way(const Vec2& from, const Vec2& to) const;

  /// Length [m] of the way, from `from` on; infinity when there is none.
  double distance(const Vec2& from, const Vec2& to) const;

 private:
  struct Node {
    Vec2 point;
    Vec2 before, after;                         ///< unit vectors to the corner's neighbours
    int part = 0;                               ///< polygon it belongs to
    std::vector<std::pair<int, double>> edges;  ///< (node, length [m]), node ascending
  };
  class Search;

  void add_part(const Polygon& polygon, int part);
  void add_corners(const Ring& ring, int part);
  void link_corners();
  void link(std::uint32_t i, std::uint32_t j, const Vec2& line);
  static bool is_taut(const Node& node, const Vec2& direction);
  Vec2 place_near(const Vec2& point) const;
  int part_of(const Vec2& place) const;

  double clearance_ = 0.3;
  WallIndex area_;                 ///< borders of the walkable area itself
  WallIndex walls_;                ///< borders of the shrunk area
  std::vector<Node> nodes_;        ///< its reflex corners
  PointTree corners_;              ///< these again
  std::vector<int> part_of_wall_;  ///< of walls_
};

}  // namespace pedzone
