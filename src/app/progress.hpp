// Progress of something long: a bar on a terminal, a plain line every half minute elsewhere.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace pedzone {

class Progress {
 public:
  /// Says what has been done so far, `elapsed` [s] after the beginning.
  using Tell = std::function<std::string(double elapsed)>;

  /// From `begin` to `end`, in any unit; an end before the beginning: unknown. Writes to standard
  /// error.
  Progress(double begin, double end);
  /// Call after each step, when `position` is reached; prints only now and then.
  void update(double position, const Tell& tell);
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
