// The command `pedzone geojson`.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

/// Adds it; `code` gets the exit code.
void add_geojson(CLI::App& app, int& code);

}  // namespace pedzone
