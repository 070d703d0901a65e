// The data inside the animation's page, as JSON.
#pragma once

#include <cstdint>
#include <string>

#include "view/animation.hpp"
#include "zone/shapes.hpp"

namespace pedzone::animation {

/// [cm] as the page has lengths. Throws InputError where that is too far away.
std::int32_t centimetres(double metres);

/// Of all persons and vehicles, at any time; empty: nobody.
Box where_anybody_is(const std::vector<AnimatedRun>& runs);

/// What the page shows when everything is to be seen: the zones; where nobody goes near them, where
/// everybody goes, too.
Box extent(const std::vector<AnimatedRun>& runs, const Place* place);

/// Roads, zones, obstacles and waypoints near `box`.
std::string scenery(const Place* place, const Box& box);

/// One run, with at most `rate` [1/s] steps.
std::string run(const AnimatedRun& run, double rate);

/// [s] the least time between steps that are kept in any of the runs.
double least_step(const std::vector<AnimatedRun>& runs, double rate);

}  // namespace pedzone::animation
