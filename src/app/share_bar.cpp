#include "app/share_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "app/clock_text.hpp"

namespace pedzone {
namespace {

constexpr double kBarEvery = 0.2, kLineEvery = 30.0;  // [s]
constexpr int kWidth = 30;

}  // namespace

ShareBar::ShareBar(std::string what)
    : what_(std::move(what)),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_(start_) {}

void ShareBar::update(double share) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < (terminal_ ? kBarEvery : kLineEvery)) {
    return;
  }
  last_ = now;
  const double spent = std::chrono::duration<double>(now - start_).count();
  const double left = share > 0.0 ? spent * (1.0 - share) / share : 0.0;
  const std::string text = fmt::format("{:3.0f} %, {} left", 100.0 * share, clock_text(left));
  if (!terminal_) {
    fmt::print(stderr, "{}: {}\n", what_, text);
    return;
  }
  const int full = static_cast<int>(share * kWidth);
  fmt::print(stderr, "\r{} [{:#<{}}{: <{}}] {} ", what_, "", full, "", kWidth - full, text);
  std::fflush(stderr);
  shown_ = true;
}

void ShareBar::finish() {
  if (shown_) fmt::print(stderr, "\r\033[K");
  shown_ = false;
}

}  // namespace pedzone
