// Random and drawn shapes, and slow but obvious answers, for the geometry tests.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "geometry/polygon.hpp"

namespace pedzone::shapes {

using Random = std::mt19937_64;

/// Uniform in [low, high). Not std::uniform_real_distribution: same numbers on every library.
double uniform(Random& random, double low, double high);

/// Counter-clockwise rectangle.
Ring box(double left, double bottom, double right, double top);
Region box_region(double left, double bottom, double right, double top);

/// Star-shaped simple ring round a centre; radii in [0.2, 1) · size.
Ring star(Random& random, const Vec2& centre, double size, int corners);

/// Any points in a square in any order: crosses itself wildly.
Ring scribble(Random& random, const Vec2& centre, double size, int corners);

/// Square [0, size]² less `count` random obstacles (stars and boxes).
Region obstacle_scene(Random& random, double size, int count);

/// Winding number of a ring round a point by summed angles.
int winding_number(const Ring& ring, const Vec2& point);

/// Membership by winding numbers; the border may go either way.
bool inside_by_winding(const Region& region, const Vec2& point);

/// Distance from a point to a segment, and to the nearest border of a region [m].
double segment_distance(const Vec2& a, const Vec2& b, const Vec2& point);
double border_distance(const Region& region, const Vec2& point);

/// Whether segments p–q and a–b have a point in common.
bool segments_meet(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b);

/// Nothing when the region keeps polygon.hpp's promises (rings simple, outer counter-clockwise,
/// holes clockwise and inside, polygons disjoint); else what is wrong. Quadratic and exact.
std::string defect(const Region& region);

}  // namespace pedzone::shapes
