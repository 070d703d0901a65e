// `pedzone inspect`: what would be controlled in a scenario, without running it.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

void add_inspect(CLI::App& app, int& code);

}  // namespace pedzone
