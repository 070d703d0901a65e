#include "geometry/wall_index.hpp"

#include <atomic>
#include <limits>

#include "geometry/segment.hpp"

namespace pedzone {
namespace {

// numerical: a point this near to a wall is on it; a thousandth of the regions' grid, a thousand
// times the rounding of coordinates.
constexpr double kOnBorder = 1e-9;  // [m]
// numerical: how far the ends of a line of sight may be behind a wall they lie on.
constexpr double kSightSlack = 1e-6;  // [m]
// numerical: reference points of cells are off the regions' millimetre grid, so that no corner
// has a coordinate in common with them.
constexpr double kOffGrid = 0.000413;  // [m]

std::vector<Wall> borders(const Region& region) {
  std::vector<Wall> walls;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      walls.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  };
  for (const Polygon& polygon : region) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return walls;
}

/// A point on the wall's line counts as a hair above it, as it does where heights are compared.
bool left_of_wall(const Wall& wall, const Vec2& point) {
  const double turn = cross(wall.b - wall.a, point - wall.a);
  return turn > 0.0 || (turn == 0.0 && wall.b.x() > wall.a.x());
}

/// Whether the way from `point` along x to `corner`, then along y to `reference` crosses the wall.
/// Sides are asked in the same manner for both parts, so that a wall through the corner is counted
/// for one of them.
bool crosses(const Wall& wall, const Vec2& point, const Vec2& corner, const Vec2& reference) {
  bool odd = false;
  if ((wall.a.y() > point.y()) != (wall.b.y() > point.y())) {
    odd = left_of_wall(wall, point) != left_of_wall(wall, corner);
  }
  if ((wall.a.x() > corner.x()) != (wall.b.x() > corner.x())) {
    odd ^= left_of_wall(wall, corner) != left_of_wall(wall, reference);
  }
  return odd;
}

/// What lies within `clearance` [m] of a segment.
class Strip {
 public:
  Strip(const Vec2& from, const Vec2& to, double clearance)
      : from_(from),
        to_(to),
        along_(to - from),
        clearance_(clearance - kOnBorder),
        beside_((clearance + kOnBorder) * along_.norm()) {}

  bool meets(const Wall& wall) const {
    // Most walls lie wholly on one side of the line: cheaper to see than a distance is to measure.
    const double a_side = cross(along_, wall.a - from_), b_side = cross(along_, wall.b - from_);
    if (std::min(a_side, b_side) > beside_ || std::max(a_side, b_side) < -beside_) return false;
    const double distance = segment_distance(from_, to_, wall.a, wall.b);
    return !(distance > 0.0 && distance >= clearance_);
  }

 private:
  Vec2 from_, to_, along_;
  double clearance_, beside_;
};

}  // namespace

std::uint64_t WallIndex::next_identity() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

WallIndex::WallIndex(const Region& walkable)
    : walls_(borders(walkable)), identity_(next_identity()), bounded_(true) {
  grid_ = WallGrid(walls_);
  mark_cells();
}

WallIndex::WallIndex(std::vector<Wall> walls)
    : walls_(std::move(walls)), identity_(next_identity()) {
  std::erase_if(walls_, [](const Wall& wall) {
    return !wall.a.allFinite() || !wall.b.allFinite() || wall.a == wall.b;
  });
  grid_ = WallGrid(walls_);
}

Vec2 WallIndex::reference(int column, int row) const {
  return grid_.low() + grid_.cell_size() * Vec2(column + 0.5, row + 0.5) + Vec2::Constant(kOffGrid);
}

bool WallIndex::reference_inside(int column, int row) const {
  return inside_of_cell_[static_cast<std::size_t>(row) * grid_.columns() + column] != 0;
}

/// A wall changes the side of all reference points to the right of where it crosses their row.
void WallIndex::mark_cells() {
  inside_of_cell_.assign(static_cast<std::size_t>(grid_.columns()) * grid_.rows(), 0);
  for (const Wall& wall : walls_) {
    const Vec2& lower = wall.a.y() < wall.b.y() ? wall.a : wall.b;
    const Vec2& upper = wall.a.y() < wall.b.y() ? wall.b : wall.a;
    for (int row = grid_.row_of(lower.y()); row <= grid_.row_of(upper.y()); ++row) {
      const double y = reference(0, row).y();
      if ((lower.y() > y) == (upper.y() > y)) continue;
      const double x =
          lower.x() + (y - lower.y()) / (upper.y() - lower.y()) * (upper.x() - lower.x());
      // The column where it crosses may be off by rounding: the side of its neighbours decides.
      int column = std::max(0, grid_.column_of(x) - 1);
      const Wall upward{lower, upper};
      while (column < grid_.columns() && left_of_wall(upward, reference(column, row))) ++column;
      if (column < grid_.columns()) {
        inside_of_cell_[static_cast<std::size_t>(row) * grid_.columns() + column] ^= 1;
      }
    }
  }
  for (int row = 0; row < grid_.rows(); ++row) {
    char* line = &inside_of_cell_[static_cast<std::size_t>(row) * grid_.columns()];
    for (int column = 1; column < grid_.columns(); ++column) line[column] ^= line[column - 1];
  }
}

void WallIndex::near(const Vec2& point, double reach, std::vector<std::uint32_t>& out) const {
  out.clear();
  const double limit2 = (reach + kOnBorder) * (reach + kOnBorder);
  visit_near(point, reach + kOnBorder, [&](std::uint32_t index) {
    const Wall& wall = walls_[index];
    if ((nearest_on(wall.a, wall.b, point) - point).squaredNorm() <= limit2) out.push_back(index);
  });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

double WallIndex::room(const Vec2& point, double limit) const {
  const std::optional<Nearest> place = nearest(point, limit);
  return place ? place->distance : limit;
}

bool WallIndex::inside(const Vec2& point) const {
  if (!bounded_) return true;
  if (!grid_.covers(point)) return false;
  const int column = grid_.column_of(point.x()), row = grid_.row_of(point.y());
  const Vec2 target = reference(column, row);
  const Vec2 corner(target.x(), point.y());
  bool odd = false;
  for (const std::uint32_t index : grid_.cell(column, row)) {
    const Wall& wall = walls_[index];
    if ((nearest_on(wall.a, wall.b, point) - point).squaredNorm() < kOnBorder * kOnBorder) {
      return true;
    }
    odd ^= crosses(wall, point, corner, target);
  }
  return reference_inside(column, row) != odd;
}

bool WallIndex::free_line(const Vec2& from, const Vec2& to, double clearance) const {
  std::uint32_t anything = 0;
  return free_line(from, to, clearance, anything);
}

bool WallIndex::free_line(const Vec2& from, const Vec2& to, double clearance,
                          std::uint32_t& in_the_way) const {
  const Strip strip(from, to, clearance);
  if (in_the_way < walls_.size() && strip.meets(walls_[in_the_way])) return false;
  return grid_.visit_along(from, to, clearance, [&](std::uint32_t index) {
    if (!strip.meets(walls_[index])) return true;
    in_the_way = index;
    return false;
  });
}

bool WallIndex::sees(const Vec2& from, const Vec2& to) const {
  return grid_.visit_along(from, to, 0.0, [&](std::uint32_t index) {
    const Wall& wall = walls_[index];
    const Vec2 along = wall.b - wall.a;
    const double length = along.norm();
    const double start = cross(along, from - wall.a) / length;
    const double end = cross(along, to - wall.a) / length;
    if (std::min(start, end) >= -kSightSlack || std::max(start, end) <= kSightSlack) return true;
    const Vec2 meeting = from + start / (start - end) * (to - from);
    const double place = along.dot(meeting - wall.a) / length;
    return place < -kSightSlack || place > length + kSightSlack;
  });
}

std::optional<WallIndex::Nearest> WallIndex::nearest(const Vec2& point, double limit) const {
  Nearest best{std::numeric_limits<std::uint32_t>::max(), Vec2::Zero(), limit * limit};
  bool found = false;
  visit_near(point, limit, [&](std::uint32_t index) {
    const Wall& wall = walls_[index];
    const Vec2 place = nearest_on(wall.a, wall.b, point);
    const double distance2 = (place - point).squaredNorm();
    // Equally near ones: the first, whatever order the cells are gone through.
    if (distance2 < best.distance || (distance2 == best.distance && index < best.wall)) {
      best = {index, place, distance2};
      found = true;
    }
  });
  if (!found) return std::nullopt;
  best.distance = std::sqrt(best.distance);
  return best;
}

/// Looks in ever larger squares. There must be a wall.
WallIndex::Nearest WallIndex::nearest_anywhere(const Vec2& point) const {
  const Vec2 outside = (grid_.low() - point).cwiseMax(point - grid_.high()).cwiseMax(Vec2::Zero());
  for (double limit = outside.norm() + grid_.cell_size();; limit *= 2.0) {
    if (const std::optional<Nearest> place = nearest(point, limit)) return *place;
  }
}

/// Unit vector from a wall's nearest place to the point; the wall's own normal on the wall itself.
Vec2 WallIndex::away_from(const Nearest& place, const Vec2& point) const {
  if (place.distance > kOnBorder) return (point - place.point) / place.distance;
  const Wall& wall = walls_[place.wall];
  return left_of((wall.b - wall.a).normalized());
}

}  // namespace pedzone
