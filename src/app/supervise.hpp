// SUMO can abort() the whole process. The work is done in a child; the parent survives its death,
// removes what it left half-written and says what happened.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pedzone {

/// Runs `work` in a child process and returns its exit code. When the child dies by a signal:
/// removes the partial files of `outputs`, prints one error, returns kExitSumo; where somebody else
/// killed it, 128 + signal. SIGINT, SIGTERM and SIGHUP are passed on to the child, which may note
/// them and end well (interrupts.hpp). The child dies with the parent.
int supervise(const std::function<int()>& work, const std::vector<std::string>& outputs);

}  // namespace pedzone
