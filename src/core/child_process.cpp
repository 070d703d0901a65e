#include "core/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace pedzone {
namespace {

constexpr int kSignalled = 128;  // shells' exit code for a program that died of a signal, plus it
constexpr int kNotStarted = 127;
constexpr std::array kOutside = {SIGKILL, SIGTERM, SIGINT, SIGHUP};

Ending ending_of(int status) {
  if (WIFSIGNALED(status)) return {0, WTERMSIG(status)};
  return {WEXITSTATUS(status), 0};
}

/// Nothing that it throws may get to the parent's part of the program.
int guarded(const std::function<int()>& work) {
  int code = 1;
  try {
    code = work();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Error: %s\n", error.what());
  }
  std::fflush(nullptr);
  return code;
}

/// Forks; the child runs `work`.
pid_t start(const std::function<int()>& work) {
  std::fflush(nullptr);  // what is buffered would be written twice
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (child > 0) return child;
  die_with_parent(parent);
  _exit(guarded(work));
}

Ending wait_for(pid_t child) { return ending_of(wait_for_child(child)); }

/// The same without input, in a folder.
int become_in(const std::string& folder, const std::vector<std::string>& command) {
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0 || chdir(folder.c_str()) != 0) {
    std::fprintf(stderr, "Error: cannot start in %s: %s\n", folder.c_str(), std::strerror(errno));
    return kNotStarted;
  }
  return become(command);
}

}  // namespace

int Ending::exit_code() const { return signal != 0 ? kSignalled + signal : code; }

bool Ending::from_outside() const {
  return std::ranges::find(kOutside, exit_code() - kSignalled) != kOutside.end();
}

std::string Ending::text() const {
  if (signal != 0) {
    return "died of signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  }
  if (from_outside()) return "was killed (signal " + std::to_string(code - kSignalled) + ")";
  return "ended with exit code " + std::to_string(code);
}

int wait_for_child(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void die_with_parent(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kSignalled + SIGKILL);  // it has died in between
}

int become(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  std::signal(SIGPIPE, SIG_DFL);  // as programs expect it, whatever this one does about it
  execvp(words.front(), words.data());
  std::fprintf(stderr, "Error: cannot start %s: %s\n", words.front(), std::strerror(errno));
  return kNotStarted;
}

Child::Child(const std::function<int()>& work)
    : pid_(start([&work] {
        setpgid(0, 0);
        sigset_t none;
        sigemptyset(&none);
        sigprocmask(SIG_SETMASK, &none, nullptr);
        return work();
      })) {
  setpgid(pid_, pid_);  // both do it, so that it is done when either goes on
}

Child::~Child() { kill(); }

std::optional<Ending> Child::poll() {
  if (ending_) return ending_;
  // Not reaped before its group is dead: until then nobody else gets its number.
  siginfo_t ended{};
  if (waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
      ended.si_pid == pid_) {
    ::kill(-pid_, SIGKILL);
    ending_ = wait_for(pid_);
  }
  return ending_;
}

void Child::ask_to_end() {
  if (!ending_) ::kill(-pid_, SIGTERM);
}

void Child::kill() {
  if (ending_) return;
  ::kill(-pid_, SIGKILL);
  ending_ = wait_for(pid_);
}

Ending run_program(const std::vector<std::string>& command, const std::string& folder) {
  return wait_for(start([&] { return become_in(folder, command); }));
}

}  // namespace pedzone
