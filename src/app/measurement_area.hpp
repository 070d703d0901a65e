// Density, speed and flow of people in a rectangle over time.
#pragma once

#include <vector>

#include "results/place.hpp"
#include "results/recording.hpp"
#include "zone/shapes.hpp"

namespace pedzone {

/// By Voronoi cells (Steffen and Seyfried 2010).
struct AreaMoment {
  double time;                                     ///< [s]
  double density;                                  ///< [persons/m²]
  double speed;                                    ///< [m/s]
  double flow() const { return density * speed; }  ///< [1/(m·s)]
};

/// Once a second, whenever somebody's cell reaches into the area. `place`: null where not known;
/// else cells end at the walls of its zones.
std::vector<AreaMoment> measure_area(const Recording& recording, const Place* place,
                                     const Box& area);

}  // namespace pedzone
