// SUMO's library takes 0.2 s to load, since it loads some 220 others: the program has the calls of
// it in a library of its own, which is loaded when SUMO is started in this process and not before.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sumo/calls/session.hpp"

namespace pedzone {

/// The type of start_in_process().
using StartInProcess = std::unique_ptr<Session>(const std::string& config,
                                                const std::vector<std::string>& words);

/// Of the pointer to it in the library.
constexpr const char* kStartInProcess = "pedzone_start_in_process";

}  // namespace pedzone
