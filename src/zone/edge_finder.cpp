#include "zone/edge_finder.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "geometry/polyline.hpp"

namespace pedzone {
namespace {

constexpr double kCellSide = 4.0;  // [m] numerical

std::int32_t cell_of(double coordinate) {
  return static_cast<std::int32_t>(std::floor(coordinate / kCellSide));
}

/// [m] negative inside.
double distance_to_outline(Ring ring, const Vec2& place) {
  const bool inside = contains({{ring, {}}}, place);
  ring.push_back(ring.front());
  const double distance = std::abs(project_on(ring, place).lateral);
  return inside ? -distance : distance;
}

}  // namespace

/// [m] of a place to a lane's border; negative inside.
double EdgeFinder::distance(int lane, const Vec2& place) const {
  const Lane& one = network_.lanes[lane];
  if (one.outline) return distance_to_outline(one.shape, place);
  return std::abs(project_on(one.shape, place).lateral) - one.width / 2.0;
}

/// Those that can be the nearest to a place of the cell: distances differ within it by no more than
/// from its middle to a corner.
const std::vector<int>& EdgeFinder::lanes_near(const Vec2& place) {
  const std::int32_t column = cell_of(place.x()), row = cell_of(place.y());
  const auto key =
      std::uint64_t{static_cast<std::uint32_t>(row)} << 32 | static_cast<std::uint32_t>(column);
  const auto [found, is_new] = near_.try_emplace(key);
  if (!is_new) return found->second;
  const Vec2 middle = (Vec2(column, row) + Vec2(0.5, 0.5)) * kCellSide;
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, int>> all;
  for (const int lane : zone_.lanes) {
    all.emplace_back(distance(lane, middle), lane);
    least = std::min(least, all.back().first);
  }
  for (const auto& [far, lane] : all) {
    if (far <= least + std::sqrt(2.0) * kCellSide) found->second.push_back(lane);
  }
  return found->second;
}

int EdgeFinder::edge_at(const Vec2& place) {
  double least = std::numeric_limits<double>::infinity();
  int edge = -1;
  for (const int lane : lanes_near(place)) {
    const double far = distance(lane, place);
    if (far >= least) continue;
    least = far;
    edge = network_.lanes[lane].edge;
  }
  return edge;
}

}  // namespace pedzone
