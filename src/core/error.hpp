// The two errors that reach the user, each with its exit code.
#pragma once

#include <stdexcept>
#include <string>

namespace pedzone {

constexpr int kExitInput = 2;  ///< the user's input is at fault
constexpr int kExitSumo = 3;   ///< SUMO failed to start, stopped with an error or died

/// Where in the user's input something is wrong. Empty fields are left out of the message.
struct InputPlace {
  std::string file = {};     ///< as the user named it
  int line = 0;              ///< 1-based; 0 where a line makes no sense (a missing file)
  std::string element = {};  ///< e.g. `<zone id="old-town"> attribute openSpace`
  std::string value = {};    ///< what was found
  std::string allowed = {};  ///< what would be accepted
};

/// Bad input: one message naming file, line, element, value and what is allowed. Exit code 2.
class InputError : public std::runtime_error {
 public:
  /// `problem` is a short clause such as "is out of range"; the place is put around it.
  InputError(const std::string& problem, const InputPlace& place);
};

/// SUMO could not be started, reported an error, or broke off. Exit code 3.
class SumoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pedzone
