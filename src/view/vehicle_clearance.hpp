// How near persons are to the vehicles that drive.
#pragma once

#include <optional>
#include <vector>

#include "results/recording.hpp"

namespace pedzone {

/// A recording's moving vehicles by step.
class VehicleClearance {
 public:
  explicit VehicleClearance(const Recording& recording);

  /// Room [m] between a person's disc and the rectangle of the nearest vehicle that drives
  /// (kHaltingSpeed) at the step; negative: they overlap. Nothing where none drives.
  std::optional<double> of(const Vec2& position, double radius, std::uint32_t step) const;

 private:
  struct Body {
    Vec2 centre, axis;
    double half_length, half_width;  ///< [m]
  };
  std::vector<std::vector<Body>> driving_;
};

}  // namespace pedzone
