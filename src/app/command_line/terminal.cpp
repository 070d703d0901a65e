#include "app/command_line/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace pedzone {
namespace {

constexpr std::string_view kRed = "\x1b[1;31m", kYellow = "\x1b[1;33m", kPlain = "\x1b[0m";

bool quiet = false;

/// https://no-color.org: set and not empty means none.
bool shows_colours() {
  const char* none = std::getenv("NO_COLOR");
  return isatty(STDERR_FILENO) == 1 && (none == nullptr || *none == '\0');
}

std::string label(std::string_view word, std::string_view colour) {
  return shows_colours() ? fmt::format("{}{}{}", colour, word, kPlain) : std::string(word);
}

}  // namespace

void add_quiet_flag(CLI::App& command) {
  command.add_flag_callback(
      "--quiet", [] { quiet = true; }, "Print warnings and errors only: no progress, no result");
}

bool is_quiet() { return quiet; }

void end_when_nobody_reads() { std::signal(SIGPIPE, SIG_DFL); }

void print_text(std::string_view text) {
  std::signal(SIGPIPE, SIG_IGN);  // for good: what is left in the buffer is flushed at exit again
  const bool printed = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if ((printed && std::fflush(stdout) == 0) || errno == EPIPE) return;
  throw std::system_error(errno, std::generic_category(), "standard output");
}

void print_result(std::string_view text) {
  if (!quiet) print_text(text);
}

void print_error(std::string_view text) {
  fmt::print(stderr, "{} {}\n", label("Error:", kRed), text);
}

void print_warning(std::string_view text) { fmt::print(stderr, "{} {}\n", warning_label(), text); }

std::string warning_label() { return label("Warning:", kYellow); }

}  // namespace pedzone
