#include "model/wall_tiles.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace pedzone {
namespace {

constexpr double kTileSize = 4.0;  ///< [m] numerical: smaller ones cost memory, larger ones time
constexpr auto kTileLattice = static_cast<std::int64_t>(kTileSize * kLatticePerMetre);

double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (a + s * along - point).norm();
}

std::vector<WallFace> faces_of(std::span<const Wall> walls, const LatticeOrigin& origin) {
  std::vector<WallFace> faces;
  std::map<std::pair<std::int32_t, std::int32_t>, bool> taken;  // points that have their disc
  for (const Wall& wall : walls) {
    const LatticePoint from = to_lattice(wall.a.x(), wall.a.y(), origin);
    const LatticePoint to = to_lattice(wall.b.x(), wall.b.y(), origin);
    const Vec2 along = Vec2(to.x - from.x, to.y - from.y) / kLatticePerMetre;
    const double length = along.norm();
    const Vec2 d = length > 0.0 ? Vec2(along / length) : Vec2(1.0, 0.0);
    const bool begin = taken.emplace(std::pair(from.x, from.y), true).second;
    const bool end = taken.emplace(std::pair(to.x, to.y), true).second;
    faces.push_back({from, static_cast<float>(d.x()), static_cast<float>(d.y()),
                     static_cast<float>(length), begin, end});
  }
  return faces;
}

}  // namespace

void WallTiles::build(std::span<const Wall> walls, double reach, const LatticeOrigin& origin) {
  walls_ = faces_of(walls, origin);
  tile_start_.clear();
  tile_walls_.clear();
  columns_ = rows_ = 0;
  if (walls.empty()) return;

  Vec2 least = walls.front().a, most = least;
  for (const Wall& wall : walls) {
    least = least.cwiseMin(wall.a).cwiseMin(wall.b);
    most = most.cwiseMax(wall.a).cwiseMax(wall.b);
  }
  least -= Vec2::Constant(reach);
  most += Vec2::Constant(reach);
  x_least_ = to_lattice(least.x()) - origin.x;
  y_least_ = to_lattice(least.y()) - origin.y;
  columns_ = static_cast<std::int64_t>((most.x() - least.x()) / kTileSize) + 1;
  rows_ = static_cast<std::int64_t>((most.y() - least.y()) / kTileSize) + 1;

  // Two passes over (wall, tile) pairs: count, then place. A shared point's disc belongs to the
  // first wall that has it, so a tile near a wall also lists the owners of that wall's ends: they
  // are as near as the point.
  const double half_diagonal = kTileSize * std::sqrt(0.5);
  const auto for_each_pair = [&](auto&& visit) {
    for (std::size_t w = 0; w < walls.size(); ++w) {
      const Vec2 low = walls[w].a.cwiseMin(walls[w].b) - Vec2::Constant(reach) - least;
      const Vec2 high = walls[w].a.cwiseMax(walls[w].b) + Vec2::Constant(reach) - least;
      const auto tile = [](double metres, std::int64_t count) {
        return std::clamp(static_cast<std::int64_t>(std::floor(metres / kTileSize)),
                          std::int64_t{0}, count - 1);
      };
      for (std::int64_t r = tile(low.y(), rows_); r <= tile(high.y(), rows_); ++r) {
        for (std::int64_t c = tile(low.x(), columns_); c <= tile(high.x(), columns_); ++c) {
          const Vec2 centre =
              least + kTileSize * Vec2(static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5);
          if (distance_to_segment(centre, walls[w].a, walls[w].b) <= reach + half_diagonal) {
            visit(static_cast<std::size_t>(r * columns_ + c), static_cast<std::uint32_t>(w));
          }
        }
      }
    }
  };
  tile_start_.assign(static_cast<std::size_t>(columns_ * rows_) + 2, 0);
  for_each_pair([&](std::size_t tile, std::uint32_t) { ++tile_start_[tile + 2]; });
  for (std::size_t t = 2; t < tile_start_.size(); ++t) tile_start_[t] += tile_start_[t - 1];
  tile_walls_.resize(tile_start_.back());
  for_each_pair(
      [&](std::size_t tile, std::uint32_t wall) { tile_walls_[tile_start_[tile + 1]++] = wall; });
}

std::span<const std::uint32_t> WallTiles::near(const LatticePoint& point) const {
  const std::int64_t c = point.x - x_least_, r = point.y - y_least_;
  if (c < 0 || r < 0 || c / kTileLattice >= columns_ || r / kTileLattice >= rows_) return {};
  const auto tile = static_cast<std::size_t>(r / kTileLattice * columns_ + c / kTileLattice);
  return {tile_walls_.data() + tile_start_[tile], tile_start_[tile + 1] - tile_start_[tile]};
}

}  // namespace pedzone
