// Points of the borders that push a person away, where a model counts points and not lines.
#pragma once

#include <cstddef>
#include <span>

#include "model/perceived.hpp"

namespace pedzone {

/// Whether the nearest point of `borders[k]` is where the distance to the whole outline has a
/// minimum: within a side, or at a corner that is nearest on both of its sides. What pushes then
/// does not depend on where a straight wall is cut in two. `borders` as in Perceived.
inline bool pushes(std::span<const Border> borders, std::size_t k) {
  const Border& border = borders[k];
  if (border.repeated) return false;
  if (border.nearest != border.a && border.nearest != border.b) return true;
  return k + 1 < borders.size() && borders[k + 1].repeated;
}

/// Unit vector from the border's nearest point to the person.
inline Vec2 away_from(const Border& border) {
  return border.distance > 0.0 ? Vec2(-border.nearest / border.distance) : border.normal;
}

}  // namespace pedzone
