#include "app/png.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "core/error.hpp"

namespace pedzone {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// One that has no name and is gone when closed.
File temporary_file() {
  File file(std::tmpfile(), std::fclose);
  if (!file) {
    throw std::runtime_error(std::string("cannot make a temporary file: ") + std::strerror(errno));
  }
  return file;
}

/// Runs the converter with these files as its standard input and output; its exit status.
int convert(std::FILE* from, std::FILE* to, int width) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(from), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(to), STDOUT_FILENO);
  std::string program = "rsvg-convert", unlimited = "--unlimited", keep = "--keep-aspect-ratio",
              size = "--width=" + std::to_string(width);
  std::array<char*, 5> words{program.data(), unlimited.data(), keep.data(), size.data(), nullptr};
  pid_t child = 0;
  const int code = posix_spawnp(&child, program.c_str(), &files, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (code == ENOENT) {
    throw InputError("cannot be made: rsvg-convert is not installed",
                     {.element = "option --out, a PNG picture",
                      .allowed = ".svg, or .png with Debian's package librsvg2-bin installed"});
  }
  if (code != 0) {
    throw std::runtime_error(std::string("cannot run rsvg-convert: ") + std::strerror(code));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

std::string png_from_svg(const std::string& svg, int width) {
  const File from = temporary_file(), to = temporary_file();
  const bool written = std::fwrite(svg.data(), 1, svg.size(), from.get()) == svg.size() &&
                       std::fflush(from.get()) == 0;
  if (!written) throw std::runtime_error("cannot write a temporary file: the disk may be full");
  std::rewind(from.get());  // the converter reads on from where its input stands
  if (const int status = convert(from.get(), to.get(), width); status != 0) {
    throw std::runtime_error("rsvg-convert failed (status " + std::to_string(status) + ")");
  }
  std::rewind(to.get());
  std::string png;
  std::array<char, 1 << 16> piece;
  for (std::size_t got = 0; (got = std::fread(piece.data(), 1, piece.size(), to.get())) > 0;) {
    png.append(piece.data(), got);
  }
  return png;
}

}  // namespace pedzone
