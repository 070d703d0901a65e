#include "study/run/signal_queue.hpp"

#include <cmath>
#include <ctime>
#include <initializer_list>

namespace pedzone::study {

SignalQueue::SignalQueue() {
  sigemptyset(&held_);
  for (const int signal : {SIGCHLD, SIGINT, SIGTERM, SIGHUP}) sigaddset(&held_, signal);
  sigprocmask(SIG_BLOCK, &held_, &before_);
}

SignalQueue::~SignalQueue() {
  while (wait(0.0) != 0) {
  }
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

int SignalQueue::wait(double seconds) {
  const double whole = std::floor(seconds);
  constexpr double kNanoseconds = 1e9;  // in a second
  timespec time{};
  time.tv_sec = static_cast<time_t>(whole);
  time.tv_nsec = static_cast<long>((seconds - whole) * kNanoseconds);
  const int signal = sigtimedwait(&held_, nullptr, &time);
  return signal > 0 ? signal : 0;
}

}  // namespace pedzone::study
