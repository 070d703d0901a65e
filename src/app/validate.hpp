// `pedzone validate`: walking models against recordings; `pedzone calibrate`: their parameters.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

/// Add the subcommands; `code` gets their exit code.
void add_validate(CLI::App& app, int& code);
void add_calibrate(CLI::App& app, int& code);

}  // namespace pedzone
