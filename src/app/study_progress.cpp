#include "app/study_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "app/clock_text.hpp"

namespace pedzone {
namespace {

constexpr auto kEvery = std::chrono::milliseconds(500);  // between two drawings of the bar
constexpr std::size_t kWidth = 30;                       // characters

}  // namespace

StudyProgress::StudyProgress(std::size_t runs, std::size_t over, int jobs)
    : runs_(runs), over_(over), jobs_(jobs), terminal_(isatty(STDERR_FILENO) == 1) {}

void StudyProgress::over(const std::string& run, const std::string& text, bool trouble,
                         double wall_s) {
  ++over_;
  ++timed_;
  wall_s_ += wall_s;
  if (!terminal_ || trouble) line(fmt::format("{} {} {}", count(), run, text));
}

void StudyProgress::note(const std::string& run, const std::string& text) {
  line(fmt::format("{} {} {}", count(), run, text));
}

void StudyProgress::update() {
  const Clock::time_point now = Clock::now();
  if (!terminal_ || (last_ != Clock::time_point::min() && now - last_ < kEvery)) return;
  last_ = now;
  const std::size_t filled = runs_ > 0 ? over_ * kWidth / runs_ : 0;
  fmt::print(stderr, "\r\x1b[K[{}{}] {} of {} runs{}", std::string(filled, '#'),
             std::string(kWidth - filled, '.'), over_, runs_, time_left());
  std::fflush(stderr);
}

void StudyProgress::finish() {
  if (terminal_) fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

std::string StudyProgress::count() const { return fmt::format("[{}/{}]", over_, runs_); }

std::string StudyProgress::time_left() const {
  if (timed_ == 0) return "";
  const double each = wall_s_ / static_cast<double>(timed_);
  return ", " + clock_text(each * static_cast<double>(runs_ - over_) / jobs_) + " left";
}

void StudyProgress::line(const std::string& text) {
  fmt::print(stderr, "{}{}\n", terminal_ ? "\r\x1b[K" : "", text);
  last_ = Clock::time_point::min();
}

}  // namespace pedzone
