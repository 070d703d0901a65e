#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <string>

#include "app/clock_text.hpp"

namespace pedzone {
namespace {

constexpr double kEvery = 0.2;  // [s] between two drawings of the bar

}  // namespace

Progress::Progress(bool bar)
    : start_(Clock::now()),
      last_(start_),
      errors_(std::cerr, [this](const std::string& line) { read(line); }) {
  bar_ = bar && line_.is_terminal();
  if (!bar_ || isatty(STDOUT_FILENO) != 1) return;
  output_.emplace(std::cout, [this](const std::string& line) {
    line_.clear();
    fmt::print("{}\n", line);
    std::fflush(stdout);
  });
}

Progress::~Progress() { finish(); }

void Progress::read(const std::string& line) {
  warnings_.read(line);
  print(line);
}

void Progress::start(double begin, double end) {
  begin_ = begin;
  end_ = end;
  start_ = last_ = Clock::now();
}

void Progress::update(double time, std::size_t controlled) {
  if (!bar_) return;
  const Clock::time_point now = Clock::now();
  const auto since = [&](Clock::time_point then) {
    return std::chrono::duration<double>(now - then).count();
  };
  if (since(last_) < kEvery) return;
  last_ = now;
  const double factor = (time - begin_) / std::max(since(start_), 1e-9);
  std::string share, end;
  if (end_ > begin_) {
    const double done = std::clamp((time - begin_) / (end_ - begin_), 0.0, 1.0);
    share = fmt::format("{} {:3.0f} %", bar_text(done), 100.0 * done);
    if (factor > 0.0) share += fmt::format(", {} left", clock_text((end_ - time) / factor));
    share += ": ";
    end = fmt::format(" of {:.0f}", end_);
  }
  // The end of a line that is too long is cut off: what matters most comes first.
  line_.draw(fmt::format("{}{:.0f}{} s, {:.1f}x real time, {} persons walked", share, time, end,
                         factor, controlled));
}

void Progress::finish() { line_.clear(); }

}  // namespace pedzone
