// Charts of a recorded run over time: a line for each person; of many, what is usual among them.
#pragma once

#include <string>

#include "results/recording.hpp"

namespace pedzone {

/// Everybody's speed [m/s], as an SVG file.
std::string speed_chart(const Recording& recording, const std::string& title);

/// Everybody's places, with axes of their own: what happens across the way is stretched.
std::string across_chart(const Recording& recording, const std::string& title);

/// Everybody's clearance [m] to the nearest vehicle that drives, as an SVG file; farther than
/// kFarClearance is not shown. Where none drives there is no line.
std::string clearance_chart(const Recording& recording, const std::string& title);

/// [m] assumed: nobody minds a vehicle from farther away; people keep 1.6 to 2.6 m.
inline constexpr double kFarClearance = 15.0;

}  // namespace pedzone
