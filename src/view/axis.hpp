// Axes of charts: round steps, and ends that they cut evenly.
#pragma once

#include <string>
#include <vector>

namespace pedzone {

/// A step of 1, 2 or 5 times a power of ten that cuts `range` into at most `parts` parts; 1 where
/// the range is none.
double round_step(double range, double parts);

/// The longest of 1, 2 or 5 times a power of ten that is at most `most` (> 0).
double round_length(double most);

/// An axis with a tick at each multiple of its step. Both ends are ticks.
struct Axis {
  double least = 0.0, most = 1.0;  ///< least < most
  double step = 1.0;               ///< > 0

  /// The shortest such axis that covers [least, most], with about `parts` steps.
  static Axis over(double least, double most, double parts);

  std::vector<double> ticks() const;
  /// A tick as text, without digits that no tick needs.
  std::string label(double tick) const;
  /// Where a value lies: 0 at the least, 1 at the most.
  double part(double value) const { return (value - least) / (most - least); }
};

}  // namespace pedzone
