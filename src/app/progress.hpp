// Progress of a run on a terminal: a bar with the time left. What SUMO and pedzone print goes above
// it, line by line.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>

#include "app/terminal_line.hpp"
#include "sumo/files/sumo_messages.hpp"

namespace pedzone {

class Progress {
 public:
  /// From now on SUMO's messages are shown and counted. `bar`: wanted, where there is a terminal.
  explicit Progress(bool bar);
  ~Progress();
  /// The run goes from `begin` to `end` [s]; a negative end is unknown.
  void start(double begin, double end);
  /// Call after each step; draws only now and then.
  void update(double time, std::size_t controlled);
  /// Prints a line above the bar.
  void print(const std::string& line) { line_.print(line); }
  /// Clears the bar. SUMO's messages are shown on.
  void finish();
  /// Of SUMO's messages so far.
  const WarningCounts& warnings() const { return warnings_; }

 private:
  using Clock = std::chrono::steady_clock;
  void read(const std::string& line);

  bool bar_ = false;
  double begin_ = 0.0, end_ = -1.0;
  TerminalLine line_;
  Clock::time_point start_, last_;
  WarningCounts warnings_;
  StreamLines errors_;
  std::optional<StreamLines> output_;  ///< where both go to one terminal
};

}  // namespace pedzone
