// What a program prints, to be read by this one.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pedzone {

struct CommandOutput {
  int code = 0;  ///< exit code; 128 + its number where a signal ended it
  std::string out, error;
};

/// Runs a program, found as a shell does but started without one, until it ends. It reads `input`.
/// Unset where there is none of that name. Throws std::system_error.
std::optional<CommandOutput> command_output(const std::vector<std::string>& command,
                                            const std::string& input = {});

}  // namespace pedzone
