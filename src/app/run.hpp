// `pedzone run`: a SUMO scenario with its persons walked through the zones.
#pragma once

#include "app/run_options.hpp"

namespace pedzone {

void add_run(CLI::App& app, int& code);

/// In a process of its own, which SUMO may end. Its exit code.
int run(const RunOptions& options);

}  // namespace pedzone
