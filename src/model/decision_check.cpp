#include "model/decision_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace pedzone {

/// Negated comparisons: what is no number is refused.
void check_decision(const std::string& whose, const Decision& decision, double preferred_speed) {
  const auto refuse = [&](const char* what, double value, const std::string& allowed) {
    throw InputError("is out of range",
                     {whose, 0, fmt::format("{} of the walking model's decision", what),
                      fmt::format("{}", value), allowed});
  };
  if (!std::isfinite(decision.direction)) refuse("direction", decision.direction, "a number");
  if (!(decision.speed >= 0.0 && decision.speed <= preferred_speed)) {
    refuse("speed", decision.speed,
           fmt::format("0 to the preferred speed, {} m/s", preferred_speed));
  }
  if (!(decision.free_distance >= 0.0)) {
    refuse("free distance", decision.free_distance, "at least 0 m");
  }
}

}  // namespace pedzone
