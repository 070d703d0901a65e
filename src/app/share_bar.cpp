#include "app/share_bar.hpp"

#include <fmt/format.h>

#include "app/clock_text.hpp"
#include "app/command_line/terminal.hpp"

namespace pedzone {
namespace {

constexpr double kBarEvery = 0.2, kLineEvery = 30.0;  // [s]

}  // namespace

ShareBar::ShareBar(std::string what)
    : what_(std::move(what)), start_(Clock::now()), last_(start_) {}

void ShareBar::update(double share) {
  if (is_quiet()) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  const Clock::time_point now = Clock::now();
  const double every = line_.is_terminal() ? kBarEvery : kLineEvery;
  if (std::chrono::duration<double>(now - last_).count() < every) return;
  last_ = now;
  const double spent = std::chrono::duration<double>(now - start_).count();
  const double left = share > 0.0 ? spent * (1.0 - share) / share : 0.0;
  const std::string text = fmt::format("{:3.0f} %, {} left", 100.0 * share, clock_text(left));
  if (line_.is_terminal()) {
    line_.draw(fmt::format("{} {} {} ", what_, bar_text(share), text));
  } else {
    line_.print(fmt::format("{}: {}", what_, text));
  }
}

void ShareBar::finish() { line_.clear(); }

}  // namespace pedzone
