#include "app/video/piped_program.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace pedzone {
namespace {

constexpr int kAbove = 10;  // numerical: no descriptor that a program is given is as high

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

struct Pipe {
  int out = -1, in = -1;  ///< what is written to `in` comes out of `out`
};

/// Both ends are closed in programs that are started; the copies that they get are not.
Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_errno("cannot make a pipe");
  Pipe pipe;
  pipe.out = fcntl(ends[0], F_DUPFD_CLOEXEC, kAbove);
  pipe.in = fcntl(ends[1], F_DUPFD_CLOEXEC, kAbove);
  close(ends[0]);
  close(ends[1]);
  if (pipe.out < 0 || pipe.in < 0) throw_errno("cannot make a pipe");
  return pipe;
}

void close_end(int& descriptor) {
  if (descriptor >= 0) close(descriptor);
  descriptor = -1;
}

}  // namespace

std::optional<std::string> installed_program(const std::vector<std::string>& names) {
  const char* path = std::getenv("PATH");
  const std::string folders = path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin";
  for (const std::string& name : names) {
    for (std::size_t at = 0; at <= folders.size();) {
      const std::size_t end = std::min(folders.find(':', at), folders.size());
      const std::filesystem::path file = std::filesystem::path(folders.substr(at, end - at)) / name;
      if (std::filesystem::is_regular_file(file) && access(file.c_str(), X_OK) == 0) {
        return file.string();
      }
      at = end + 1;
    }
  }
  return std::nullopt;
}

PipedProgram::PipedProgram(const std::vector<std::string>& command, int reads_at, int writes_at,
                           const std::string& scratch)
    : name_(std::filesystem::path(command.front()).filename().string()) {
  std::signal(SIGPIPE, SIG_IGN);  // send() tells of a program that is gone
  Pipe to, from;
  if (reads_at >= 0) to = make_pipe();
  if (writes_at >= 0) from = make_pipe();
  said_ = memfd_create("said", MFD_CLOEXEC);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (said_ < 0 || nothing < 0) throw_errno("cannot start a program");
  child_.emplace([&] {
    dup2(nothing, STDIN_FILENO);
    dup2(said_, STDOUT_FILENO);
    dup2(said_, STDERR_FILENO);
    if (reads_at >= 0) dup2(to.out, reads_at);
    if (writes_at >= 0) dup2(from.in, writes_at);
    if (!scratch.empty()) setenv("TMPDIR", scratch.c_str(), 1);
    return become(command);
  });
  close(nothing);
  close_end(to.out);
  close_end(from.in);
  to_ = to.in;
  from_ = from.out;
}

PipedProgram::~PipedProgram() {
  child_.reset();
  for (int* descriptor : {&to_, &from_, &said_}) close_end(*descriptor);
}

void PipedProgram::fail() {
  throw std::runtime_error(name_ + " ended before its work was done. " + said());
}

void PipedProgram::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = write(to_, bytes.data(), bytes.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

std::string PipedProgram::hear_until(char end) {
  std::array<char, 1 << 16> piece;
  for (std::size_t looked = 0;;) {
    const std::size_t at = heard_.find(end, looked);
    if (at != std::string::npos) {
      std::string text = heard_.substr(0, at);
      heard_.erase(0, at + 1);
      return text;
    }
    looked = heard_.size();
    const ssize_t got = read(from_, piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail();
    heard_.append(piece.data(), static_cast<std::size_t>(got));
  }
}

Ending PipedProgram::finish() {
  constexpr auto kEvery = std::chrono::milliseconds(5);
  close_end(to_);
  for (;;) {
    if (const auto ending = child_->poll()) return *ending;
    std::this_thread::sleep_for(kEvery);
  }
}

std::string PipedProgram::said() {
  constexpr std::size_t kMost = 2000;  // its last words
  std::string text(4096, '\0');
  const off_t size = lseek(said_, 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(kMost));
  const ssize_t got = pread(said_, text.data(), text.size(), from);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return text;
}

}  // namespace pedzone
