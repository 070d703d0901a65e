// Bridges and underpasses: shapes that overlap on different levels must not become one area.
#pragma once

#include <string>
#include <vector>

#include "zone/selection.hpp"

namespace pedzone {

/// Shapes that overlap with more than this between their heights are on different levels [m].
/// Given by the task: less than the clear height of any underpass, more than a kerb or a ramp.
constexpr double kLevelStep = 2.5;

/// Height [m] of a lane at its point nearest to `point`; 0 where the file gives no heights.
double height_near(const Lane& lane, const Vec2& point);

/// Whether a lane has any other height than 0.
bool has_heights(const Lane& lane);

/// Whether two lanes overlap somewhere on different levels.
bool on_different_levels(const Lane& a, const Lane& b);
/// Whether they overlap somewhere on the same one.
bool on_one_level(const Lane& a, const Lane& b);

/// Removes edges from the selection until no two of its lanes overlap on different levels: each
/// time the edge with the most conflicts, of those the one with the fewest links to edges that
/// persons may use, of those the shortest. One warning each.
void separate_levels(const Network& network, Selection& selection,
                     std::vector<std::string>& warnings);

}  // namespace pedzone
