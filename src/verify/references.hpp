// Published values that the tests compare with.
#pragma once

#include "verify/standard_test.hpp"

namespace pedzone::verify {

/// Speed [m/s] at a density [persons/m²] in (0, 5.4]: Weidmann 1993.
double weidmann_speed(double density);
/// Greatest flow of that curve [persons/(m s)], at 1.75 persons/m².
constexpr double kWeidmannFlow = 1.22;

/// Density [persons/m²] and speed [m/s] measured in corridors: Zhang, Klingsch, Schadschneider and
/// Seyfried 2011 and 2012 (Jülich). One way 1.8 m wide, two ways 3.6 m. Their free speed was
/// 1.55 ± 0.18 m/s.
const Points& juelich_one_way();
const Points& juelich_two_ways();

/// By straight lines between points; the first's before it; none beyond the last.
std::optional<double> interpolated(const Points& points, double x);

/// How far outside of what was published a speed may be, as a share of it: assumed, the spread
/// between published diagrams.
constexpr double kBandSlack = 0.15;

struct Band {
  double low, high;
};
/// Between Weidmann and Jülich's one way, widened by the slack; beyond Jülich's points Weidmann's
/// alone.
Band one_way_band(double density);
/// Jülich's two ways, widened by the slack. `density` within their points.
Band two_way_band(double density);

/// Weidmann's curve from 0.2 to 5 persons/m² for a chart.
Reference weidmann_reference();

}  // namespace pedzone::verify
