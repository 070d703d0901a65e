// The last line of a terminal, where progress is shown: whatever else is printed goes above it.
#pragma once

#include <string>

namespace pedzone {

/// On standard error. Elsewhere than on a terminal nothing is drawn.
class TerminalLine {
 public:
  TerminalLine();
  bool is_terminal() const { return terminal_; }
  void draw(const std::string& text);
  void clear();
  /// Prints a line for good, with its end.
  void print(const std::string& line);

 private:
  bool terminal_, drawn_ = false;
};

/// "[####......]"; `share` [0, 1] of it is full.
std::string bar_text(double share);

}  // namespace pedzone
