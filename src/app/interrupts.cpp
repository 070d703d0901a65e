#include "app/interrupts.hpp"

#include <csignal>
#include <ctime>
#include <initializer_list>

namespace pedzone {
namespace {

constexpr double kSameRequest = 0.5;  // [s]

// What a signal handler may touch.
volatile std::sig_atomic_t noted = 0;
volatile std::sig_atomic_t receiver = 0;
timespec noted_at{};

double seconds_since(const timespec& then) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec - then.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - then.tv_nsec);
}

void note(int signal) {
  if (noted == 0) {
    noted = signal;
    clock_gettime(CLOCK_MONOTONIC, &noted_at);
  } else if (seconds_since(noted_at) > kSameRequest) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

void pass_on(int signal) { kill(static_cast<pid_t>(receiver), signal); }

void handle_by(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

}  // namespace

void note_interrupts() { handle_by(note); }

int noted_interrupt() { return noted; }

void pass_interrupts_to(pid_t child) {
  receiver = child;
  handle_by(pass_on);
}

}  // namespace pedzone
