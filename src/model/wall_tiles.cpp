#include "model/wall_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace pedzone {
namespace {

constexpr double kTileSize = 4.0;  ///< [m] numerical: smaller ones cost memory, larger ones time
/// [m] added to the reach, for rounding to the lattice.
constexpr double kMargin = 0.01;

LatticePoint end_of(const WallFace& face) {
  return {face.from.x + static_cast<std::int32_t>(to_lattice(face.dx * face.length)),
          face.from.y + static_cast<std::int32_t>(to_lattice(face.dy * face.length))};
}

double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (a + s * along - point).norm();
}

std::vector<WallFace> faces_of(std::span<const Wall> walls, const LatticeOrigin& origin) {
  std::vector<WallFace> faces;
  std::set<std::pair<std::int32_t, std::int32_t>> taken;  // points that have their disc
  for (const Wall& wall : walls) {
    const LatticePoint from = to_lattice(wall.a.x(), wall.a.y(), origin);
    const LatticePoint to = to_lattice(wall.b.x(), wall.b.y(), origin);
    const Vec2 along = Vec2(to.x - from.x, to.y - from.y) / kLatticePerMetre;
    const double length = along.norm();
    const Vec2 d = length > 0.0 ? Vec2(along / length) : Vec2(1.0, 0.0);
    const bool begin = taken.emplace(from.x, from.y).second;
    const bool end = taken.emplace(to.x, to.y).second;
    faces.push_back({from, static_cast<float>(d.x()), static_cast<float>(d.y()),
                     static_cast<float>(length), begin, end});
  }
  return faces;
}

}  // namespace

void WallTiles::build(std::span<const Wall> walls, double reach, const LatticeOrigin& origin) {
  faces_ = faces_of(walls, origin);
  const std::int64_t grown = to_lattice(reach + kMargin);
  const auto box = [&](std::size_t i) {
    const LatticePoint a = faces_[i].from, b = end_of(faces_[i]);
    return LatticeBox{std::min(a.x, b.x) - grown, std::min(a.y, b.y) - grown,
                      std::max(a.x, b.x) + grown, std::max(a.y, b.y) + grown};
  };
  LatticeBox bounds = faces_.empty() ? LatticeBox{0, 0, -1, -1} : box(0);
  for (std::size_t i = 1; i < faces_.size(); ++i) {
    const LatticeBox b = box(i);
    bounds = {std::min(bounds.left, b.left), std::min(bounds.low, b.low),
              std::max(bounds.right, b.right), std::max(bounds.high, b.high)};
  }
  const auto meets = [&](std::size_t i, const LatticeBox& tile) {
    const auto metres = [](std::int64_t x, std::int64_t y) -> Vec2 {
      return Vec2(static_cast<double>(x), static_cast<double>(y)) / kLatticePerMetre;
    };
    const LatticePoint a = faces_[i].from, b = end_of(faces_[i]);
    const Vec2 centre = 0.5 * (metres(tile.left, tile.low) + metres(tile.right, tile.high));
    return distance_to_segment(centre, metres(a.x, a.y), metres(b.x, b.y)) <=
           reach + kMargin + kTileSize * std::sqrt(0.5);
  };
  tiles_.build(bounds, to_lattice(kTileSize), faces_.size(), box, meets);
}

}  // namespace pedzone
