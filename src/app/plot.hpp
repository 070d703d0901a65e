// `pedzone plot`: pictures of a recorded run.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

/// Adds the command; `code` becomes its exit code.
void add_plot(CLI::App& app, int& code);

}  // namespace pedzone
