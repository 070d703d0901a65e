// A corridor without ends, by carrying people from one to the other (trial.hpp).
#pragma once

#include "verify/measures.hpp"
#include "verify/standard_test.hpp"

namespace pedzone::verify {

struct PeriodicCorridor {
  double length = 26.0, width = 2.0;  ///< [m]
  std::size_t people = 1;
  bool both_ways = false;  ///< every other one, by chance, goes the other way

  Region ground() const;
  Drawing drawing() const;
};

/// The corridor with its people walking; their stream is 0 towards +x, else 1. Places and ways
/// depend on the seed alone.
class CorridorTrial : public Trial {
 public:
  CorridorTrial(const PeriodicCorridor& corridor, const RunInput& input);
};

/// The direction of a person of that stream.
inline Vec2 corridor_way(const Participant& participant) {
  return {participant.stream == 0 ? 1.0 : -1.0, 0.0};
}

/// Density [persons/m²] and speed [m/s] of a time span, over the whole corridor.
Point state_of(const PeriodicCorridor& corridor, const RunInput& input, double from, double until);

/// How many people make that density.
std::size_t people_at(double density, double length, double width);

}  // namespace pedzone::verify
