#include "model/wall_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pedzone {
namespace {

constexpr double kTileSize = 4.0;  ///< [m] numerical: smaller ones cost memory, larger ones time
constexpr double kTilesPerWall = 256.0, kTilesAtLeast = 65536.0;  // at most so many tiles
/// [m] added to the reach, for rounding to the lattice.
constexpr double kMargin = 0.01;

double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (a + s * along - point).norm();
}

/// [1] sine of a turn that still counts as straight on. Numerical: lattice rounding of 1 m.
constexpr float kStraight = 1e-4F;

std::int32_t halfway(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(nearest_integer((static_cast<double>(a) + b) / 2.0));
}

WallFace face_of(const Wall& wall, const LatticeOrigin& origin) {
  const LatticePoint from = to_lattice(wall.a.x(), wall.a.y(), origin);
  const LatticePoint to = to_lattice(wall.b.x(), wall.b.y(), origin);
  const Vec2 along = Vec2(to.x - from.x, to.y - from.y) / kLatticePerMetre;
  const double length = along.norm();
  const Vec2 d = length > 0.0 ? Vec2(along / length) : Vec2(1.0, 0.0);
  WallFace face{};
  face.from = from;
  face.to = to;
  face.middle = {halfway(from.x, to.x), halfway(from.y, to.y)};
  face.dx = static_cast<float>(d.x());
  face.dy = static_cast<float>(d.y());
  face.length = static_cast<float>(length);
  return face;
}

std::vector<WallFace> faces_of(std::span<const Wall> walls, const LatticeOrigin& origin) {
  using Point = std::pair<std::int32_t, std::int32_t>;
  std::vector<WallFace> faces;
  std::map<Point, std::vector<std::size_t>> beginning, ending;  // walls at each point
  for (const Wall& wall : walls) {
    faces.push_back(face_of(wall, origin));
    const LatticePoint from = faces.back().from, to = faces.back().to;
    beginning[{from.x, from.y}].push_back(faces.size() - 1);
    ending[{to.x, to.y}].push_back(faces.size() - 1);
  }
  for (const auto& [point, begin] : beginning) {
    const auto end = ending.find(point);
    if (begin.size() != 1 || end == ending.end() || end->second.size() != 1) {
      faces[begin.front()].begins = true;  // one disc for all that meet here
      continue;
    }
    WallFace& face = faces[begin.front()];
    const WallFace& before = faces[end->second.front()];
    face.before_x = before.dx;
    face.before_y = before.dy;
    const float turn = before.dx * face.dy - before.dy * face.dx;
    const float onward = before.dx * face.dx + before.dy * face.dy;
    face.corner = turn < -kStraight || (turn <= kStraight && onward < 0.0F);
  }
  for (const auto& [point, end] : ending) {
    if (!beginning.contains(point)) faces[end.front()].ends = true;
  }
  return faces;
}

}  // namespace

void WallTiles::build(std::span<const Wall> walls, double reach, const LatticeOrigin& origin) {
  faces_ = faces_of(walls, origin);
  const std::int64_t grown = to_lattice(reach + kMargin);
  const auto box = [&](std::size_t i) {
    const LatticePoint a = faces_[i].from, b = faces_[i].to;
    return LatticeBox{std::min(a.x, b.x) - grown, std::min(a.y, b.y) - grown,
                      std::max(a.x, b.x) + grown, std::max(a.y, b.y) + grown};
  };
  LatticeBox bounds = faces_.empty() ? LatticeBox{0, 0, -1, -1} : box(0);
  for (std::size_t i = 1; i < faces_.size(); ++i) {
    const LatticeBox b = box(i);
    bounds = {std::min(bounds.left, b.left), std::min(bounds.low, b.low),
              std::max(bounds.right, b.right), std::max(bounds.high, b.high)};
  }
  const std::int64_t size =
      tile_size_for(bounds, to_lattice(kTileSize),
                    kTilesPerWall * static_cast<double>(faces_.size()) + kTilesAtLeast);
  const auto meets = [&](std::size_t i, const LatticeBox& tile) {
    const auto metres = [](std::int64_t x, std::int64_t y) -> Vec2 {
      return Vec2(static_cast<double>(x), static_cast<double>(y)) / kLatticePerMetre;
    };
    const LatticePoint a = faces_[i].from, b = faces_[i].to;
    const Vec2 centre = 0.5 * (metres(tile.left, tile.low) + metres(tile.right, tile.high));
    return distance_to_segment(centre, metres(a.x, a.y), metres(b.x, b.y)) <=
           reach + kMargin + static_cast<double>(size) / kLatticePerMetre * std::sqrt(0.5);
  };
  tiles_.build(bounds, size, faces_.size(), box, meets);
}

}  // namespace pedzone
