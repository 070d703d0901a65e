// That a vehicle speeds up, as people see it.
#pragma once

#include <algorithm>
#include <cmath>

namespace pedzone {

/// How much faster a vehicle has become in the last second. What is longer ago counts less
/// (exponential mean of the acceleration), so that nothing but its last speed is remembered.
class SpeedGain {
 public:
  explicit SpeedGain(double speed = 0.0) : speed_(speed) {}

  /// It drives at `speed` [m/s] now, `dt` [s] after the time before; in between it changed evenly.
  void follow(double speed, double dt) {
    if (dt <= 0.0) return;
    const double kept = std::exp(-dt / kSecond);
    gained_ = gained_ * kept + (speed - speed_) / dt * kSecond * (1.0 - kept);
    speed_ = speed;
  }

  /// [m/s] ≥ 0 how much faster than now its mean speed in the next second is, if it goes on so.
  double ahead() const { return std::max(0.0, gained_ / 2.0); }

 private:
  static constexpr double kSecond = 1.0;  // [s] assumed

  double speed_, gained_ = 0.0;  // [m/s]
};

}  // namespace pedzone
