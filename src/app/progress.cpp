#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "app/clock_text.hpp"

namespace pedzone {
namespace {

constexpr double kOnTerminal = 0.2;  // [s] between two drawings of the bar
constexpr double kElsewhere = 30.0;  // [s] between two plain lines
constexpr int kBarWidth = 24;        // characters

}  // namespace

Progress::Progress(double begin, double end)
    : begin_(begin),
      end_(end),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(start_) {}

void Progress::update(double time, std::size_t controlled) {
  const Clock::time_point now = Clock::now();
  const auto since = [&](Clock::time_point then) {
    return std::chrono::duration<double>(now - then).count();
  };
  if (since(last_) < (terminal_ ? kOnTerminal : kElsewhere)) return;
  last_ = now;
  const double elapsed = std::max(since(start_), 1e-9);
  const double factor = (time - begin_) / elapsed;
  std::string line = fmt::format("{:.0f} s simulated", time);
  std::string left;
  if (end_ > begin_) {
    const double share = std::clamp((time - begin_) / (end_ - begin_), 0.0, 1.0);
    line = fmt::format("{:3.0f} %  {:.0f} of {:.0f} s simulated", 100.0 * share, time, end_);
    if (factor > 0.0) left = fmt::format(", {} left", clock_text((end_ - time) / factor));
    if (terminal_) {
      const int filled = static_cast<int>(share * kBarWidth);
      line = "[" + std::string(filled, '#') + std::string(kBarWidth - filled, '.') + "] " + line;
    }
  }
  line += fmt::format(", {:.1f}x real time, {} persons controlled{}", factor, controlled, left);
  fmt::print(stderr, "{}{}{}", terminal_ ? "\r\x1b[K" : "", line, terminal_ ? "" : "\n");
  std::fflush(stderr);
  shown_ = true;
}

void Progress::finish() {
  if (terminal_ && shown_) fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace pedzone
