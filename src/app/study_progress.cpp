#include "app/study_progress.hpp"

#include <fmt/format.h>

#include "app/clock_text.hpp"
#include "app/command_line/terminal.hpp"

namespace pedzone {
namespace {

constexpr auto kEvery = std::chrono::milliseconds(500);  // between two drawings of the bar

}  // namespace

StudyProgress::StudyProgress(std::size_t runs, std::size_t over, int jobs)
    : runs_(runs), over_(over), jobs_(jobs) {}

void StudyProgress::over(const std::string& run, const std::string& text, bool trouble,
                         double wall_s) {
  ++over_;
  ++timed_;
  wall_s_ += wall_s;
  if (trouble || (!terminal_.is_terminal() && !is_quiet()))
    line(fmt::format("{} {} {}", count(), run, text));
}

void StudyProgress::note(const std::string& run, const std::string& text) {
  line(fmt::format("{} {} {}", count(), run, text));
}

void StudyProgress::update() {
  if (is_quiet()) return;
  const Clock::time_point now = Clock::now();
  if (!terminal_.is_terminal() || (last_ != Clock::time_point::min() && now - last_ < kEvery))
    return;
  last_ = now;
  const double share = runs_ > 0 ? static_cast<double>(over_) / static_cast<double>(runs_) : 0.0;
  terminal_.draw(fmt::format("{} {} of {} runs{}", bar_text(share), over_, runs_, time_left()));
}

void StudyProgress::finish() { terminal_.clear(); }

std::string StudyProgress::count() const { return fmt::format("[{}/{}]", over_, runs_); }

std::string StudyProgress::time_left() const {
  if (timed_ == 0) return "";
  const double each = wall_s_ / static_cast<double>(timed_);
  return ", " + clock_text(each * static_cast<double>(runs_ - over_) / jobs_) + " left";
}

void StudyProgress::line(const std::string& text) {
  terminal_.print(text);
  last_ = Clock::time_point::min();
}

}  // namespace pedzone
