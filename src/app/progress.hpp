// Progress of a long run: a bar on a terminal, a plain line every half minute elsewhere.
#pragma once

#include <chrono>
#include <cstddef>

namespace pedzone {

class Progress {
 public:
  /// `end` [s] simulated; negative when unknown. Writes to standard error.
  Progress(double begin, double end);
  /// Call after each step; prints only now and then.
  void update(double time, std::size_t controlled);
  /// Clears the bar.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  double begin_, end_;
  bool terminal_;
  Clock::time_point start_, last_;
  bool shown_ = false;
};

}  // namespace pedzone
