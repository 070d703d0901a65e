// A program that is talked to while it runs, over pipes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/child_process.hpp"

namespace pedzone {

/// The first of these programs that is installed, by its path; nothing: none of them.
std::optional<std::string> installed_program(const std::vector<std::string>& names);

class PipedProgram {
 public:
  /// Runs `command`. It reads what is sent from its descriptor `reads_at` and is heard on its
  /// descriptor `writes_at`; what it writes to standard output and error is kept for said().
  /// A negative number: no such pipe. It does not outlive this object. Throws std::system_error.
  /// `scratch`: folder for its temporary files; empty: as for this process.
  PipedProgram(const std::vector<std::string>& command, int reads_at, int writes_at,
               const std::string& scratch = {});
  ~PipedProgram();
  PipedProgram(const PipedProgram&) = delete;
  PipedProgram& operator=(const PipedProgram&) = delete;

  /// Throws std::runtime_error where the program reads no more.
  void send(std::string_view bytes);
  /// What it writes up to a byte, without that. Throws std::runtime_error where it ends before.
  std::string hear_until(char end);
  /// Nothing more is sent; waits until it has ended.
  Ending finish();
  /// What it has told on standard output and error.
  std::string said();

 private:
  [[noreturn]] void fail();

  std::string name_;
  int said_ = -1, to_ = -1, from_ = -1;  ///< descriptors of this process
  std::string heard_;                    ///< behind what hear_until() has returned
  std::optional<Child> child_;
};

}  // namespace pedzone
