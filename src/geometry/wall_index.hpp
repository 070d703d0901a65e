// The walls of a walkable area (its borders), found fast.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/polygon.hpp"
#include "geometry/wall_grid.hpp"

namespace pedzone {

/// Borders of a region in a uniform grid. Immutable after construction; safe from many threads.
class WallIndex {
 public:
  WallIndex() = default;
  explicit WallIndex(const Region& walkable);
  /// For scenes that have walls but no area around them (tests, benchmarks): inside() is then
  /// true everywhere.
  explicit WallIndex(std::vector<Wall> walls);

  std::span<const Wall> walls() const { return walls_; }

  /// Tells this content from any other in the program; copies share it. 0: no walls.
  std::uint64_t identity() const { return walls_.empty() ? 0 : identity_; }

  /// Indices of the walls that may be within `reach` [m] of `point`, ascending, each once,
  /// appended to `out` (cleared first). A superset: all that are within reach are there.
  void near(const Vec2& point, double reach, std::vector<std::uint32_t>& out) const;

  /// Calls visit(index) for all of these and others, some of them more than once.
  template <class Visit>
  void visit_near(const Vec2& point, double reach, Visit visit) const {
    const Vec2 margin = Vec2::Constant(reach);
    grid_.visit_box(point - margin, point + margin, [&](std::uint32_t index) {
      visit(index);
      return true;
    });
  }

  /// Distance [m] to the nearest wall, or `limit` where none is nearer.
  double room(const Vec2& point, double limit) const;

  /// Index of the nearest wall, of equally near ones the first. There must be a wall.
  std::uint32_t nearest_wall(const Vec2& point) const { return nearest_anywhere(point).wall; }

  /// Whether the point is inside the region (border included).
  bool inside(const Vec2& point) const;

  /// Whether the segment from → to meets no wall within `clearance` [m] of it.
  bool free_line(const Vec2& from, const Vec2& to, double clearance = 0.0) const;

  /// The same for who asks again and again from nearly the same place: `in_the_way` is the wall
  /// that is looked at first, and becomes the one that was found.
  bool free_line(const Vec2& from, const Vec2& to, double clearance,
                 std::uint32_t& in_the_way) const;

  /// Whether the segment crosses no wall. Its own ends may lie on walls; a wall's end point on
  /// the way counts as crossed.
  bool sees(const Vec2& from, const Vec2& to) const;

  /// The point nearest to `point` that is inside with `clearance` [m] to all walls where there is
  /// room for it (with what room there is elsewhere). Returns `point` itself when it qualifies.
  /// A point inside is not moved through a wall.
  Vec2 nearest_inside(const Vec2& point, double clearance) const;

  /// Moves a disc of `radius` [m] from `from` (inside) towards `to`: stops or slides at walls,
  /// never ends outside, never passes through a wall. Returns where it ends. In passages narrower
  /// than the disc its centre keeps what room there is; where it stands nearer to a wall than its
  /// radius, it gains room with every call.
  Vec2 slide(const Vec2& from, const Vec2& to, double radius) const;

 private:
  static std::uint64_t next_identity();

  /// The place of a wall that is nearest to a point.
  struct Nearest {
    std::uint32_t wall = 0;
    Vec2 point = Vec2::Zero();
    double distance = 0.0;  ///< [m]
  };
  /// Where a moving disc meets a wall.
  struct Hit {
    double share = 0.0;          ///< of the move, [0, 1]
    Vec2 normal = Vec2::Zero();  ///< unit, from the wall to the disc's centre
  };
  /// A move along walls and the two walls that ended it, if any.
  struct Walk {
    Vec2 end = Vec2::Zero();
    bool jammed = false;
    Vec2 first = Vec2::Zero(), second = Vec2::Zero();  ///< normals
  };

  void mark_cells();
  bool reference_inside(int column, int row) const;
  Vec2 reference(int column, int row) const;

  std::optional<Nearest> nearest(const Vec2& point, double limit) const;
  Nearest nearest_anywhere(const Vec2& point) const;
  Vec2 away_from(const Nearest& place, const Vec2& point) const;

  bool has_room(const Vec2& point, double clearance) const;
  std::optional<Vec2> nearest_with_room(const Vec2& point, double clearance, double reach,
                                        bool in_sight) const;
  Vec2 just_inside(const Nearest& place) const;

  std::optional<Hit> first_hit(const Vec2& from, const Vec2& move, double radius) const;
  Walk walk_along(const Vec2& from, const Vec2& move, double radius) const;
  std::optional<Vec2> way_through(const Vec2& from, const Vec2& move, double radius,
                                  double room_kept, const Walk& jam) const;
  Vec2 squeeze(const Vec2& from, const Vec2& move, double radius, const Walk& jam) const;
  Vec2 push_out(const Vec2& point, double radius, double step) const;
  Vec2 gain_room(const Vec2& point, const Vec2& push, double before) const;

  std::vector<Wall> walls_;
  std::uint64_t identity_ = 0;
  WallGrid grid_;
  bool bounded_ = false;              ///< built from a region: inside() means something
  std::vector<char> inside_of_cell_;  ///< whether each cell's reference point is inside
};

}  // namespace pedzone
