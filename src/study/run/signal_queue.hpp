// Signals of this process as things to wait for, instead of interruptions.
#pragma once

#include <csignal>

namespace pedzone::study {

/// Holds back SIGCHLD and what asks the process to end (SIGINT, SIGTERM, SIGHUP) as long as it
/// lives. Those that nobody has taken by then are dropped.
class SignalQueue {
 public:
  SignalQueue();
  ~SignalQueue();
  SignalQueue(const SignalQueue&) = delete;
  SignalQueue& operator=(const SignalQueue&) = delete;

  /// The next signal; 0 where there is none within so many seconds, at least 0.
  int wait(double seconds);

 private:
  sigset_t held_, before_;
};

}  // namespace pedzone::study
