#include "view/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pedzone {

double round_step(double range, double parts) {
  if (!(range > 0.0) || !std::isfinite(range)) return 1.0;
  const double rough = range / parts, ten = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (rough <= step * ten) return step * ten;
  }
  return 10.0 * ten;
}

double round_length(double most) {
  const double ten = std::pow(10.0, std::floor(std::log10(most)));
  for (const double length : {5.0, 2.0}) {
    if (length * ten <= most) return length * ten;
  }
  return ten;
}

Axis Axis::over(double least, double most, double parts) {
  constexpr double kSlack = 1e-9;  // [steps] numerical: an end that is a tick stays one
  Axis axis;
  axis.step = round_step(most - least, parts);
  axis.least = std::floor(least / axis.step + kSlack) * axis.step;
  axis.most = std::ceil(most / axis.step - kSlack) * axis.step;
  if (axis.most <= axis.least) axis.most = axis.least + axis.step;
  return axis;
}

std::vector<double> Axis::ticks() const {
  std::vector<double> all;
  const auto first = std::lround(least / step), last = std::lround(most / step);
  for (auto i = first; i <= last; ++i) all.push_back(static_cast<double>(i) * step);
  return all;
}

std::string Axis::label(double tick) const {
  const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  return fmt::format("{:.{}f}", tick, digits);
}

}  // namespace pedzone
