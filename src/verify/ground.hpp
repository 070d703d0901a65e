// Where a standard test is walked: a zone made in code, without a network.
#pragma once

#include <initializer_list>
#include <string>

#include "zone/zone.hpp"

namespace pedzone::verify {

/// Axis-parallel rectangle [m], counter-clockwise.
Ring box(double x0, double y0, double x1, double y1);

/// What those rings cover together.
Region joined(std::initializer_list<Ring> rings);

/// The region turned counter-clockwise about the origin by `angle` [rad].
Region turned(const Region& region, double angle);
Vec2 turned(const Vec2& point, double angle);

/// A zone with that walkable area, all the rest being walls that nobody sees through, and the
/// parameters' defaults. `model`: as make_model() takes it.
Zone zone_of(const Region& walkable, const std::string& model);

}  // namespace pedzone::verify
