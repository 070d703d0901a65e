// Runs a command's work and turns what it throws into a message and an exit code.
#pragma once

#include <functional>

namespace pedzone {

/// 0; kExitInput or kExitSumo with the error on standard error; 1 for anything else.
int guarded(const std::function<void()>& work);
/// The same; what the work returns where nothing is thrown.
int guarded_code(const std::function<int()>& work);

}  // namespace pedzone
