#include "geometry/near_points.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone {

void NearPoints::build(std::span<const Vec2> points) {
  by_x_.clear();
  for (const Vec2& point : points) {
    by_x_.push_back({point, static_cast<std::uint32_t>(by_x_.size())});
  }
  std::ranges::sort(by_x_, {}, [](const Entry& entry) { return entry.point.x(); });
}

std::vector<std::uint32_t> NearPoints::within(const Vec2& place, double reach) const {
  std::vector<std::uint32_t> near;
  const auto x = [](const Entry& entry) { return entry.point.x(); };
  auto at = std::ranges::lower_bound(by_x_, place.x() - reach, {}, x);
  for (; at != by_x_.end() && at->point.x() <= place.x() + reach; ++at) {
    if (std::abs(at->point.y() - place.y()) <= reach) near.push_back(at->index);
  }
  std::ranges::sort(near);
  return near;
}

}  // namespace pedzone
