#include "app/supervise.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "app/command_line/terminal.hpp"
#include "app/interrupts.hpp"
#include "core/child_process.hpp"
#include "core/error.hpp"
#include "results/complete_file.hpp"

namespace pedzone {

int supervise(const std::function<int()>& work, const std::vector<std::string>& outputs) {
  std::fflush(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) {
    print_error(fmt::format("cannot start a process for SUMO: {}", std::strerror(errno)));
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
  if (signal == SIGPIPE) return 128 + SIGPIPE;  // nobody reads any more: no word more, either
  if (signal == SIGINT) {
    fmt::print(stderr, "\nInterrupted; no output was written.\n");
    return 128 + SIGINT;
  }
  if (signal == SIGKILL || signal == SIGTERM || signal == SIGHUP) {  // not its own doing
    print_error(fmt::format("the run was killed (signal {}); no output was written.", signal));
    return 128 + signal;
  }
  print_error(fmt::format(
      "SUMO died in the middle of the run (signal {}: {}); no output was written. "
      "What it printed before is above. (Where that names ignore-route-errors, somebody "
      "came to an edge shorter than a step: SUMO goes on with "
      "`-- --ignore-route-errors true`.)",
      signal, strsignal(signal)));
  return kExitSumo;
}

}  // namespace pedzone
