#include "core/command_output.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace pedzone {
namespace {

constexpr int kSignalled = 128;  // shells' exit code for a program that a signal ended, plus it

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// A file without a name: unlike a pipe it holds any amount while nobody reads.
File scratch() {
  File file(std::tmpfile(), std::fclose);
  if (!file) throw std::system_error(errno, std::generic_category(), "cannot make a scratch file");
  return file;
}

std::string content(std::FILE* file) {
  std::string text;
  std::rewind(file);
  for (int next = std::fgetc(file); next != EOF; next = std::fgetc(file)) {
    text += static_cast<char>(next);
  }
  return text;
}

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? kSignalled + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

std::optional<CommandOutput> command_output(const std::vector<std::string>& command) {
  const File out = scratch(), error = scratch();
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(error.get()), STDERR_FILENO);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, words.front(), &files, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed == ENOENT) return std::nullopt;
  if (failed != 0) {
    throw std::system_error(failed, std::generic_category(), "cannot start " + command.front());
  }
  const int code = wait_for(process);
  return CommandOutput{code, content(out.get()), content(error.get())};
}

}  // namespace pedzone
