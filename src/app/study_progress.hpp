// Progress of a study: one bar on a terminal, one line for each finished run elsewhere.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "app/terminal_line.hpp"

namespace pedzone {

class StudyProgress {
 public:
  /// `over` runs of `runs` are over already; `jobs` are made at a time. Writes to standard error.
  StudyProgress(std::size_t runs, std::size_t over, int jobs);
  /// One more is over; `text`: how. `trouble`: to be seen on a terminal, too.
  void over(const std::string& run, const std::string& text, bool trouble, double wall_s);
  /// Something to be known about a run that goes on.
  void note(const std::string& run, const std::string& text);
  /// Draws the bar now and then.
  void update();
  /// Clears the bar.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::string count() const;
  std::string time_left() const;
  void line(const std::string& text);

  std::size_t runs_, over_;
  int jobs_;
  std::size_t timed_ = 0;
  double wall_s_ = 0.0;  ///< [s] of the runs in timed_
  TerminalLine terminal_;
  Clock::time_point last_ = Clock::time_point::min();
};

}  // namespace pedzone
