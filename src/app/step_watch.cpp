#include "app/step_watch.hpp"

#include <fmt/format.h>

#include <chrono>

#include "app/interrupts.hpp"
#include "sumo/calls/session.hpp"

namespace pedzone {
namespace {

constexpr double kLong = 10.0;     // [s] assumed: a step of a large network takes less
constexpr double kPatience = 3.0;  // [s] assumed: for a step to end after an interrupt
constexpr std::chrono::milliseconds kLook{100};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

StepWatch::StepWatch(bool wanted) {
  if (wanted) thread_ = std::thread([this] { watch(); });
}

StepWatch::~StepWatch() {
  over_ = true;
  if (thread_.joinable()) thread_.join();
}

void StepWatch::begin(const char* what) {
  since_ = now();
  what_ = what;
}

void StepWatch::end() { what_ = nullptr; }

void StepWatch::watch() {
  for (; !over_; std::this_thread::sleep_for(kLook)) {
    if (what_ == nullptr) continue;
    tell(now() - since_);
    if (noted_interrupt() == 0) continue;
    if (interrupted_ < 0.0) interrupted_ = now();
    if (now() - interrupted_ >= kPatience) hang_up();
  }
}

void StepWatch::tell(double waited) {
  const char* what = what_;
  const double since = since_;
  if (waited < kLong || told_ == since || what == nullptr) return;
  told_ = since;
  fmt::print(stderr, "Waiting since {:.0f} s {}.\n", waited, what);
}

}  // namespace pedzone
