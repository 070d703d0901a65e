#include "app/supervise.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "app/interrupts.hpp"
#include "core/child_process.hpp"
#include "core/error.hpp"
#include "results/complete_file.hpp"
#include "study/run/process.hpp"

namespace pedzone {

using study::die_with_parent;

int supervise(const std::function<int()>& work, const std::vector<std::string>& outputs) {
  std::fflush(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) {
    fmt::print(stderr, "Error: cannot start a process for SUMO: {}\n", std::strerror(errno));
    return 1;
  }
  if (child == 0) {
    die_with_parent(parent);
    const int code = work();
    std::fflush(nullptr);
    _exit(code);  // SUMO's static objects have been closed; their destructors are not trusted
  }
  // The child ends by itself when it is interrupted; the parent waits to clean up after it.
  pass_interrupts_to(child);
  const int status = wait_for_child(child);
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  for (const std::string& output : outputs) std::remove(CompleteFile::partial(output).c_str());
  const int signal = WTERMSIG(status);
  if (signal == SIGINT) {
    fmt::print(stderr, "\nInterrupted; no output was written.\n");
    return 128 + SIGINT;
  }
  if (signal == SIGKILL || signal == SIGTERM || signal == SIGHUP) {  // not its own doing
    fmt::print(stderr, "Error: the run was killed (signal {}); no output was written.\n", signal);
    return 128 + signal;
  }
  fmt::print(stderr,
             "Error: SUMO died in the middle of the run (signal {}: {}); no output was written. "
             "What it printed before is above.\n",
             signal, strsignal(signal));
  return kExitSumo;
}

}  // namespace pedzone
