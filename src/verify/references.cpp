#include "verify/references.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone::verify {
namespace {

constexpr double kFreeSpeed = 1.34, kGamma = 1.913, kMostDensity = 5.4;  // measured: Weidmann 1993

}  // namespace

double weidmann_speed(double density) {
  return kFreeSpeed * (1.0 - std::exp(-kGamma * (1.0 / density - 1.0 / kMostDensity)));
}

const Points& juelich_one_way() {
  static const Points points{{0.69, 1.35}, {1.26, 1.12}, {1.81, 0.86}, {2.22, 0.59}, {3.16, 0.34}};
  return points;
}

const Points& juelich_two_ways() {
  static const Points points{{0.60, 1.48}, {1.07, 1.25}, {1.66, 0.84}, {2.09, 0.65}, {2.79, 0.49}};
  return points;
}

std::optional<double> interpolated(const Points& points, double x) {
  constexpr double kSame = 1e-9;  // numerical
  if (x <= points.front().x) return points.front().y;
  if (x > points.back().x + kSame) return {};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point &a = points[i - 1], &b = points[i];
    if (x <= b.x) return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
  }
  return points.back().y;
}

Band one_way_band(double density) {
  const double weidmann = weidmann_speed(density);
  const double juelich = interpolated(juelich_one_way(), density).value_or(weidmann);
  return {(1.0 - kBandSlack) * std::min(weidmann, juelich),
          (1.0 + kBandSlack) * std::max(weidmann, juelich)};
}

Band two_way_band(double density) {
  const double speed = interpolated(juelich_two_ways(), density).value_or(weidmann_speed(density));
  return {(1.0 - kBandSlack) * speed, (1.0 + kBandSlack) * speed};
}

Reference weidmann_reference() {
  Reference reference{"Weidmann 1993", {}, true};
  for (int k = 4; k <= 100; ++k) {
    const double density = 0.05 * k;
    reference.points.push_back({density, weidmann_speed(density)});
  }
  return reference;
}

}  // namespace pedzone::verify
