// The command `pedzone animate`.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

/// Adds it; `code` gets the exit code.
void add_animate(CLI::App& app, int& code);

}  // namespace pedzone
