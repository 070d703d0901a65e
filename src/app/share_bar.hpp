// Progress of work whose share done is known: a bar on a terminal, a plain line now and then
// elsewhere.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "app/terminal_line.hpp"

namespace pedzone {

class ShareBar {
 public:
  explicit ShareBar(std::string what);
  /// `share` [0, 1]; from any thread. Prints only now and then, to standard error.
  void update(double share);
  /// Clears the bar.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  TerminalLine line_;
  Clock::time_point start_, last_;
  std::mutex mutex_;
};

}  // namespace pedzone
