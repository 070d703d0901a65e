#include "view/label_places.hpp"

#include <algorithm>

namespace pedzone {

std::optional<Vec2> LabelPlaces::take(const Vec2& at, double distance, const Vec2& size) {
  const Vec2 away = Vec2::Constant(distance) + 0.5 * size;
  for (const Vec2& side : {Vec2(0, -1), Vec2(0, 1), Vec2(1, 0), Vec2(-1, 0)}) {
    const Vec2 centre = at + (distance > 0.0 ? side.cwiseProduct(away) : Vec2(0, 0));
    const Box box(centre - 0.5 * size, centre + 0.5 * size);
    if (!picture_.contains(box) || !free(box)) continue;
    taken_.push_back(box);
    return centre;
  }
  return std::nullopt;
}

bool LabelPlaces::free(const Box& box) const {
  return std::none_of(taken_.begin(), taken_.end(),
                      [&](const Box& other) { return other.intersects(box); });
}

}  // namespace pedzone
