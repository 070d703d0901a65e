#include "app/terminal_line.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace pedzone {
namespace {

constexpr std::size_t kWidth = 30;  // characters
constexpr std::size_t kUsual = 80;  // characters in a line, where the terminal does not tell
constexpr const char* kClear = "\r\x1b[K";

/// A longer line would take two, and only one is cleared.
std::size_t columns() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return known ? size.ws_col : kUsual;
}

}  // namespace

TerminalLine::TerminalLine() : terminal_(isatty(STDERR_FILENO) == 1) {}

void TerminalLine::draw(const std::string& text) {
  if (!terminal_) return;
  fmt::print(stderr, "{}{}", kClear, text.substr(0, columns() - 1));
  std::fflush(stderr);
  drawn_ = true;
}

void TerminalLine::clear() {
  if (!drawn_) return;
  fmt::print(stderr, "{}", kClear);
  std::fflush(stderr);
  drawn_ = false;
}

void TerminalLine::print(const std::string& line) {
  clear();
  fmt::print(stderr, "{}\n", line);
  std::fflush(stderr);
}

std::string bar_text(double share) {
  const auto full = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * kWidth);
  return "[" + std::string(full, '#') + std::string(kWidth - full, '.') + "]";
}

}  // namespace pedzone
