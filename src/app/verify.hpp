// `pedzone verify`: the standard tests of walking.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

/// Adds the command; running it sets `code`.
void add_verify(CLI::App& app, int& code);

}  // namespace pedzone
