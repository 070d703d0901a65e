// The command `pedzone maps`.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

/// Adds it; `code` gets the exit code.
void add_maps(CLI::App& app, int& code);

}  // namespace pedzone
