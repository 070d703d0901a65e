// Points of the borders that push a person away, where a model counts points and not lines.
#pragma once

#include <cstddef>

#include "geometry/segment.hpp"
#include "model/perceived.hpp"

namespace pedzone {

/// Whether the person's goal is a place at that border (a portal, mostly), where it would never
/// arrive if the border kept it off.
inline bool goal_at(const Border& border, const Perceived& who) {
  constexpr double kSlack = 0.02;  // [m] numerical: an aim that touches the border with the body
  if (who.goal_direction.dot(border.normal) >= 0.0) return false;
  const Vec2 goal = who.goal_distance * who.goal_direction;
  return (nearest_on(border.a, border.b, goal) - goal).norm() <= who.radius + kSlack;
}

/// Whether the nearest point of border k pushes the person: it is where the distance to the whole
/// outline has a minimum (within a side, or at a corner that is nearest on both of its sides, so
/// that it does not matter where a straight wall is cut in two), and the goal is not at it.
inline bool pushes(const Perceived& who, std::size_t k) {
  const Border& border = who.borders[k];
  if (border.repeated || goal_at(border, who)) return false;
  if (border.nearest != border.a && border.nearest != border.b) return true;
  return k + 1 < who.borders.size() && who.borders[k + 1].repeated;
}

/// Unit vector from the border's nearest point to the person.
inline Vec2 away_from(const Border& border) {
  return border.distance > 0.0 ? Vec2(-border.nearest / border.distance) : border.normal;
}

}  // namespace pedzone
