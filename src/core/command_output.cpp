#include "core/command_output.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "core/child_process.hpp"

namespace pedzone {
namespace {

constexpr int kSignalled = 128;  // shells' exit code for a program that a signal ended, plus it

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// A file without a name: unlike a pipe it holds any amount while nobody reads. Its reader begins
/// with the text.
File scratch(const std::string& text = {}) {
  File file(std::tmpfile(), std::fclose);
  if (!file) throw std::system_error(errno, std::generic_category(), "cannot make a scratch file");
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot write a scratch file");
  }
  std::rewind(file.get());
  return file;
}

std::string content(std::FILE* file) {
  std::string text;
  std::rewind(file);
  std::array<char, 1 << 16> piece;
  for (std::size_t got = 0; (got = std::fread(piece.data(), 1, piece.size(), file)) > 0;) {
    text.append(piece.data(), got);
  }
  return text;
}

int code_of(int status) {
  return WIFSIGNALED(status) ? kSignalled + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

std::optional<CommandOutput> command_output(const std::vector<std::string>& command,
                                            const std::string& input) {
  const File in = scratch(input), out = scratch(), error = scratch();
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(error.get()), STDERR_FILENO);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, words.front(), &files, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed == ENOENT) return std::nullopt;
  if (failed != 0) {
    throw std::system_error(failed, std::generic_category(), "cannot start " + command.front());
  }
  return CommandOutput{code_of(wait_for_child(process)), content(out.get()), content(error.get())};
}

}  // namespace pedzone
