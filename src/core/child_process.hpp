// Processes that do not outlive the one that started them, whatever it dies of.
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pedzone {

/// How a process ended.
struct Ending {
  int code = 0;    ///< exit code, where signal is 0
  int signal = 0;  ///< that it died of; 0: none

  bool good() const { return code == 0 && signal == 0; }
  /// As shells have it: 128 + signal where there is one.
  int exit_code() const;
  /// Ended by somebody else (killed, interrupted, out of memory), be it itself or, as its exit code
  /// 128 + signal says, what it had started.
  bool from_outside() const;
  /// For people, e.g. "ended with exit code 3".
  std::string text() const;
};

/// Waits until the child has ended, however often a signal interrupts that: its status, as of
/// waitpid().
int wait_for_child(pid_t child);

/// Has the kernel kill this process as soon as its parent dies, which was `parent` when this one
/// was forked. What this process starts has to say so for itself; programs keep it.
void die_with_parent(pid_t parent);

/// Becomes a program, found as a shell does, in a process that was forked for it. Where it cannot
/// be started, says so on standard error and returns 127, the exit code for that.
int become(const std::vector<std::string>& command);

/// A process that runs a function, in a process group of its own with all that it starts.
class Child {
 public:
  /// Its exit code is what `work` returns. Signals are as if nobody had blocked them. Throws
  /// std::system_error where none can be started.
  explicit Child(const std::function<int()>& work);
  /// Kills it and its group where it still runs.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  pid_t id() const { return pid_; }
  /// How it ended; unset while it runs. Whatever it had started is killed then.
  std::optional<Ending> poll();
  /// Asks it and its group to end (SIGTERM), and does not wait.
  void ask_to_end();
  /// Kills it and its group, and waits until it is gone.
  void kill();

 private:
  pid_t pid_;
  std::optional<Ending> ending_;
};

/// Runs a program as become() does, in a folder, with this process's standard output and error and
/// without input, and waits for it. It dies with this process. Its exit code is 127 where it cannot
/// be started.
Ending run_program(const std::vector<std::string>& command, const std::string& folder);

}  // namespace pedzone
